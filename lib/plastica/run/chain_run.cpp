#include "plastica/run/chain_run.hpp"

#include "plastica/run/chain_float.hpp"
#include "plastica/run/chain_runner_make.hpp"
#include "plastica/run/lane_program.hpp"

namespace plastica {
namespace {

using chain::Planar;
using chain::Spatial;
using chain::Twist;
using chain::View;

/// Joints that are rigid in translation; `check_solver` refuses others.
std::unique_ptr<ChainProgram> make_float_program(const ChainModel& model) {
  switch (model.level) {
    case Level::Twist: return make_float_program(model, View<Twist<float>>{});
    case Level::Planar: return make_float_program(model, View<Planar<float>>{model.across});
    default: return make_float_program(model, View<Spatial<float>>{});
  }
}

}  // namespace

std::vector<bool> ChainProgram::run_with(std::span<const LaneCase> cases) {
  run(*cases.front().material, *cases.front().hooks, *cases.front().response);
  std::vector<bool> done(cases.size(), false);
  done.front() = true;
  return done;
}

std::unique_ptr<ChainProgram> make_chain_program(const ChainModel& model) {
  if (steps_in_lanes(model)) return make_lone_lane(model);
  if (model.options.precision == Precision::Float) return make_float_program(model);
  const bool elastic = model.options.translation == JointTranslation::Elastic;
  switch (model.level) {
    case Level::Twist: return make_program<Twist<double>, false>(model, View<Twist<double>>{});
    case Level::Planar: {
      const View<Planar<double>> view{model.across};
      if (elastic) return make_program<Planar<double>, true>(model, view);
      return make_program<Planar<double>, false>(model, view);
    }
    default: {
      const View<Spatial<double>> view{};
      if (elastic) return make_program<Spatial<double>, true>(model, view);
      return make_program<Spatial<double>, false>(model, view);
    }
  }
}

}  // namespace plastica
