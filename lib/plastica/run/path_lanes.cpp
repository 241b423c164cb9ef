#include "plastica/run/path_lanes.hpp"

#include <algorithm>

#include "plastica/chain/layout.hpp"
#include "plastica/model/support_kind.hpp"

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

}  // namespace

std::optional<solve::LaneLaw> lane_law(const ChainModel& model) {
  const YieldModel yields = model.scene.yield_model;
  if (yields == YieldModel::Elastic) return solve::LaneLaw::Elastic;
  // The other yield models see several forces at once, the axial one among them.
  if (yields != YieldModel::PerAxis) return {};
  switch (model.scene.material.hardening.law) {
    case HardeningLaw::Ideal: return solve::LaneLaw::Ideal;
    case HardeningLaw::Linear: return solve::LaneLaw::Linear;
    default: return {};
  }
}

std::string_view why_alone(const ChainModel& model) {
  const SolverOptions& options = model.options;
  const Scene& scene = model.scene;
  if (options.analysis == Analysis::Dynamics) {
    return is_articulated(options.scheme)
               ? ""
               : "of motions those of the articulated schemes alone ride in lanes (solver.scheme)";
  }
  if (options.precision != Precision::Double) return "at rest single precision has no lanes";
  if (options.translation != JointTranslation::Rigid) return "its joints stretch and shear";
  if (model.level == Level::Twist) return "it is only twisted";
  if (options.control != PathControl::Auto && options.control != PathControl::Load) {
    return "its path is not followed by the load (solver.control)";
  }
  if (scene.yield_model != YieldModel::Elastic && scene.yield_model != YieldModel::PerAxis) {
    return "it yields by several forces at once (rules.yield_model)";
  }
  if (!lane_law(model)) return "its hardening law has no lanes";
  const bool has_pillar =
      std::any_of(scene.supports.begin(), scene.supports.end(),
                  [](const Support& support) { return traits_of(support).one_sided; });
  if (has_pillar) return "a support lets go";
  if (!has_instruction_set(options.isa)) return "the processor lacks the instruction set";
  return "";
}

bool continues_in_lanes(const ChainModel& model) {
  return model.options.analysis == Analysis::Statics && why_alone(model).empty();
}

bool same_path_lanes(const ChainModel& a, const ChainModel& b) {
  return continues_in_lanes(a) && continues_in_lanes(b) && a.level == b.level &&
         a.across == b.across && a.options.isa == b.options.isa && lane_law(a) == lane_law(b) &&
         a.layout.segment_regions == b.layout.segment_regions && same_supports(a, b) &&
         same_loads(a, b) && same_masses(a, b);
}

std::unique_ptr<LaneProgram> make_path_lanes(const ChainModel& model) {
  if (model.level == Level::Planar) return make_planar_path_lanes(model);
  return make_spatial_path_lanes(model);
}

}  // namespace plastica
