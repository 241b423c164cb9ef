#include "plastica/run/lane_shape.hpp"

#include <algorithm>

#include "plastica/chain/layout.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/run/lane_program.hpp"

namespace plastica {
namespace {

std::size_t segment_at(const ChainModel& model, const Place& place) {
  return chain::segment_point(model.layout, fraction_of(place, model.layout.ends)).segment;
}

bool same_supports(const ChainModel& a, const ChainModel& b) {
  const auto& x = a.scene.supports;
  const auto& y = b.scene.supports;
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [&](const Support& s, const Support& t) {
                      // Beds end at segments' ends, which may differ.
                      return !s.to && !t.to && s.kind == t.kind && s.held() == t.held() &&
                             segment_at(a, s.at) == segment_at(b, t.at);
                    });
}

bool same_loads(const ChainModel& a, const ChainModel& b) {
  const auto& x = a.scene.loads;
  const auto& y = b.scene.loads;
  return std::equal(x.begin(), x.end(), y.begin(), y.end(), [&](const Load& s, const Load& t) {
    return s.follows == t.follows && s.to.has_value() == t.to.has_value() &&
           segment_at(a, s.at) == segment_at(b, t.at);
  });
}

/// Their weights are loads like others.
bool same_masses(const ChainModel& a, const ChainModel& b) {
  const auto& x = a.scene.masses;
  const auto& y = b.scene.masses;
  return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                    [&](const PointMass& s, const PointMass& t) {
                      return segment_at(a, s.at) == segment_at(b, t.at);
                    });
}

/// As chain/builder.hpp asks.
bool has_gravity(const Scene& scene) {
  double square = 0.0;
  for (const double g : scene.gravity) square += g * g;
  return square > 0.0;
}

/// Loads, supports that move and gravity follow the same histories, in their order.
bool same_histories(const Scene& a, const Scene& b) {
  const auto same_load = [](const Load& x, const Load& y) { return x.history == y.history; };
  const auto same_support = [](const Support& x, const Support& y) {
    return x.moves() == y.moves() && (!x.moves() || x.history == y.history);
  };
  return has_gravity(a) == has_gravity(b) &&
         (!has_gravity(a) || a.gravity_history == b.gravity_history) &&
         std::equal(a.loads.begin(), a.loads.end(), b.loads.begin(), b.loads.end(), same_load) &&
         std::equal(a.supports.begin(), a.supports.end(), b.supports.begin(), b.supports.end(),
                    same_support);
}

}  // namespace

std::optional<solve::LaneLaw> lane_law(const ChainModel& model) {
  const YieldModel yields = model.scene.yield_model;
  if (yields == YieldModel::Elastic) return solve::LaneLaw::Elastic;
  // The other yield models see several forces at once, the axial one among them.
  if (yields != YieldModel::PerAxis || has_own_rates(model.scene.material)) return {};
  switch (model.scene.material.hardening.law) {
    case HardeningLaw::Ideal: return solve::LaneLaw::Ideal;
    case HardeningLaw::Linear: return solve::LaneLaw::Linear;
    case HardeningLaw::VoceChaboche: return solve::LaneLaw::VoceChaboche;
    case HardeningLaw::Multilinear: return solve::LaneLaw::Multilinear;
  }
  return {};
}

std::string_view why_alone(const ChainModel& model) {
  const SolverOptions& options = model.options;
  const Scene& scene = model.scene;
  const bool moves = options.analysis == Analysis::Dynamics;
  if (moves && is_articulated(options.scheme)) return "";
  if (options.precision != Precision::Double) {
    return "single precision has lanes by the articulated schemes alone";
  }
  if (options.translation != JointTranslation::Rigid) return "its joints stretch and shear";
  if (model.level == Level::Twist) return "it is only twisted";
  if (moves && options.step_error > 0.0) return "its steps follow their error (solver.step_error)";
  if (!model.cuts.empty()) return "joints are cut in it";
  if (!moves && options.control != PathControl::Auto && options.control != PathControl::Load) {
    return "its path is not followed by the load (solver.control)";
  }
  if (scene.yield_model != YieldModel::Elastic && scene.yield_model != YieldModel::PerAxis) {
    return "it yields by several forces at once (rules.yield_model)";
  }
  if (!lane_law(model)) return "its yield stress depends on the rate";
  const bool has_pillar =
      std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support& support) { return traits_of(support).one_sided; });
  if (has_pillar) return "a support lets go";
  if (!has_instruction_set(options.isa)) return "the processor lacks the instruction set";
  return "";
}

bool same_shape(const ChainModel& a, const ChainModel& b) {
  return a.level == b.level && a.across == b.across && a.options.isa == b.options.isa &&
         lane_law(a) == lane_law(b) && a.layout.segment_regions == b.layout.segment_regions &&
         same_supports(a, b) && same_loads(a, b) && same_masses(a, b);
}

bool same_times(const ChainModel& a, const ChainModel& b) {
  return a.stops == b.stops && a.recorded == b.recorded && same_histories(a.scene, b.scene);
}

}  // namespace plastica
