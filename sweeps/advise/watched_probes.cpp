#include "sweeps/advise/watched_probes.hpp"

#include <algorithm>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/section.hpp"
#include "plastica/model/support_kind.hpp"
#include "plastica/run/path_stops.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kRounding = 1e-9;

double scale_of(const Setup& setup, const Probe& probe) {
  const Scene& scene = setup.scene;
  const double length = scene.beam.length;
  const double modulus = scene.material.youngs_modulus;
  const SectionProperties section = section_properties(scene.section, scene.material.poisson_ratio);
  const double moment =
      modulus * std::max(section.second_moment_x, section.second_moment_y) / length;
  const double duration = path_stops(scene, setup.solver).time.back();
  switch (dimension_of(probe.quantity, scene.drive.deformation)) {
    case Dimension::Length: return length;
    case Dimension::Strain:
    case Dimension::Angle: return 1.0;
    case Dimension::Stress: return modulus;
    case Dimension::Moment: return moment;
    case Dimension::Force: return moment / length;
    case Dimension::Velocity: return length / duration;
    case Dimension::AngularVelocity: return 1.0 / duration;
    case Dimension::Energy: return moment;
    default: return 0.0;
  }
}

bool says_nothing(const Probe& probe) {
  if (probe.quantity == ProbeQuantity::LoadFactor) return true;
  return probe.quantity == ProbeQuantity::Energy &&
         (probe.energy == EnergyKind::Residual || probe.energy == EnergyKind::NumericalDissipation);
}

/// The angle of a joint that stays elastic falls with the joint's length, but for a hinge's, and
/// that of a start which a support lets turn.
bool falls_with_its_joint(const Scene& scene, const Probe& probe) {
  if (!is_angle_of_joint(probe.quantity) || scene.yield_model != YieldModel::Elastic) return false;
  const std::vector<double> ends = segment_ends(scene);
  if (nearest_segment_end(probe.at, ends) == 0) {
    const auto axis = static_cast<std::size_t>(probe.component);
    return std::ranges::any_of(scene.supports, [&](const Support& support) {
      const HeldFreedoms held = support.held();
      const bool holds = axis < 3 ? held[3 + axis] : held[3] || held[4] || held[5];
      return holds && nearest_segment_end(support.at, ends) == 0;
    });
  }
  return std::ranges::none_of(scene.supports, [&](const Support& support) {
    return traits_of(support).releases &&
           nearest_segment_end(support.at, ends) == nearest_segment_end(probe.at, ends);
  });
}

}  // namespace

WatchedProbes watched_probes(const Setup& setup, const std::vector<std::string>& names) {
  const std::vector<Probe>& probes = setup.scene.probes;
  for (const std::string& name : names) {
    const bool there =
        std::any_of(probes.begin(), probes.end(), [&](const Probe& p) { return p.name == name; });
    if (!there) throw InputError({}, "--of", name, "is no probe of the scene");
  }
  WatchedProbes found;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Probe& probe = probes[i];
    const bool named = std::find(names.begin(), names.end(), probe.name) != names.end();
    if (!names.empty() && !named) continue;
    const bool falls = falls_with_its_joint(setup.scene, probe);
    if (falls && !names.empty()) {
      throw InputError({}, "--of", probe.name,
                       "is the angle of one joint, which falls with the joint's length; name a "
                       "rotation");
    }
    if (falls || (names.empty() && says_nothing(probe))) {
      found.left_out.push_back(probe.name);
      continue;
    }
    found.watched.push_back({i, probe.name, kRounding * scale_of(setup, probe)});
  }
  if (found.watched.empty()) {
    throw InputError({}, "probe", "", "is missing: advice needs one to look at");
  }
  return found;
}

}  // namespace plastica::sweeps
