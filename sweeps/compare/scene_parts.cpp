#include "sweeps/compare/scene_parts.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/run/chain_model.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::sweeps {
bool is_at_end(const Place& place, double fraction, const Setup& setup) {
  const int segments = setup.scene.beam.segments;
  if (place.segment) return *place.segment == (fraction == 0.0 ? 0 : segments);
  return place.fraction == fraction;
}

double distance_of(const Place& place, const Setup& setup) {
  const double length = setup.scene.beam.length;
  if (!place.segment) return length * place.fraction;
  // Segments may differ in length.
  return length * fraction_of(place, prepare(setup.scene, setup.solver).chain->layout.ends);
}

void require_scene(bool holds, std::string_view rule) {
  if (!holds) throw InputError({}, "", "", rule);
}

namespace {

void require_rest(const Setup& setup) {
  require_scene(setup.solver.analysis == Analysis::Statics, "is for a beam at rest");
}

}  // namespace

Cantilever cantilever_of(const Setup& setup) {
  const Scene& scene = setup.scene;
  require_rest(setup);
  require_scene(!scene.is_coupon() && scene.supports.size() == 1 &&
                    scene.supports[0].kind == SupportKind::Clamp && !scene.supports[0].hold &&
                    !scene.supports[0].moves() && is_at_end(scene.supports[0].at, 0.0, setup),
                "is for a beam with a clamp at its start as its one support");
  require_scene(scene.beam.shape == BeamShape::Straight && scene.regions.empty(),
                "is for a straight, even beam");
  const bool weightless = scene.gravity == std::array<double, 3>{};
  require_scene(scene.loads.size() == 1 && !scene.loads[0].to && !scene.loads[0].follows &&
                    is_at_end(scene.loads[0].at, 1.0, setup) && weightless,
                "is for one load, at the beam's end, that keeps its direction");
  Cantilever beam;
  beam.length = scene.beam.length;
  beam.section = section_properties(scene.section, scene.material.poisson_ratio);
  beam.bending_stiffness = scene.material.youngs_modulus * beam.section.second_moment_x;
  const double factor = scene.loads[0].history.at(end_time(setup));
  beam.force = scene.loads[0].force;
  beam.moment = scene.loads[0].moment;
  for (double& component : beam.force) component *= factor;
  for (double& component : beam.moment) component *= factor;
  return beam;
}

namespace {

/// How the ends are held against bending in the y-z plane.
theory::BeamEnds ends_of(const Setup& setup) {
  using theory::BeamEnds;
  const auto& supports = setup.scene.supports;
  const auto holds = [&](std::size_t k, std::size_t freedom) {
    return supports[k].held()[freedom] && !supports[k].moves();
  };
  constexpr std::size_t kY = 1;
  constexpr std::size_t kRx = 3;
  const std::string_view rule =
      "is for a beam that is clamped or pinned at its start, and free, "
      "clamped, pinned or on a roller at its end";
  require_scene(!supports.empty() && supports.size() <= 2 &&
                    is_at_end(supports[0].at, 0.0, setup) && holds(0, kY),
                rule);
  const bool clamped = holds(0, kRx);
  if (supports.size() == 1) {
    require_scene(clamped, rule);
    return BeamEnds::ClampedFree;
  }
  require_scene(is_at_end(supports[1].at, 1.0, setup) && holds(1, kY), rule);
  if (clamped) return holds(1, kRx) ? BeamEnds::ClampedClamped : BeamEnds::ClampedPinned;
  require_scene(!holds(1, kRx), rule);
  return BeamEnds::PinnedPinned;
}

}  // namespace

BentBeam bent_beam_of(const Setup& setup) {
  const Scene& scene = setup.scene;
  require_rest(setup);
  require_scene(
      !scene.is_coupon() && scene.beam.shape == BeamShape::Straight && scene.regions.empty(),
      "is for a straight, even beam");
  const bool heavy = scene.gravity != std::array<double, 3>{};
  require_scene(scene.loads.size() == (heavy ? 0 : 1), "is for one load, or gravity alone");
  BentBeam bent;
  bent.section = section_properties(scene.section, scene.material.poisson_ratio);
  bent.beam.ends = ends_of(setup);
  bent.beam.length = scene.beam.length;
  bent.beam.bending_stiffness = scene.material.youngs_modulus * bent.section.second_moment_x;
  if (heavy) {
    require_scene(scene.masses.empty(), "is for a beam without point masses");
    require_scene(scene.gravity[0] == 0.0 && scene.gravity[2] == 0.0, "is for gravity along y");
    bent.beam.load.distributed = scene.gravity_history.at(end_time(setup)) * scene.gravity[1] *
                                 scene.material.density * bent.section.area;
    return bent;
  }
  const Load& load = scene.loads[0];
  const bool across = load.force[0] == 0.0 && load.force[2] == 0.0 && load.moment[1] == 0.0 &&
                      load.moment[2] == 0.0 && !load.follows;
  require_scene(across, "is for a force along y or a moment about x that keeps its direction");
  const double factor = load.history.at(end_time(setup));
  if (load.to) {
    const bool whole = is_at_end(load.at, 0.0, setup) && is_at_end(*load.to, 1.0, setup);
    require_scene(whole && load.moment[0] == 0.0, "is for a spread force along the whole beam");
    bent.beam.load.distributed = factor * load.force[1];
  } else {
    bent.beam.load.position = distance_of(load.at, setup);
    bent.beam.load.force = factor * load.force[1];
    bent.beam.load.moment = -factor * load.moment[0];  // turns the slope dy/dz up
  }
  return bent;
}

void require_elastic(const Setup& setup, double moment) {
  const Scene& scene = setup.scene;
  if (scene.yield_model == YieldModel::Elastic) return;
  const bool at_cap =
      scene.yield_model != YieldModel::Fibre && scene.yield_cap == YieldCap::FullyPlastic;
  const auto section = section_properties(scene.section, scene.material.poisson_ratio);
  const double modulus = at_cap ? section.plastic_section_modulus_x : section.section_modulus_x;
  const double limit = scene.material.yield_stress * modulus;
  require_scene(moment <= limit * (1.0 + 1e-9),
                "is for a beam that stays elastic: this one yields at a moment of " +
                    model_detail::figure(limit) + " N m, and the largest is " +
                    model_detail::figure(moment) + " N m");
}

double largest_factor(const History& history, const Setup& setup) {
  const double end = end_time(setup);
  double largest = std::abs(history.at(end));
  for (std::size_t k = 0; k < history.time.size() && history.time[k] <= end; ++k) {
    largest = std::max(largest, std::abs(history.factor[k]));
  }
  return largest;
}

const Probe& end_probe(const Setup& setup, const Quantity& quantity) {
  require_scene(quantity.kind == QuantityKind::Probe && quantity.take == Take::End,
                "is for a probe at the end of the run");
  return setup.scene.probes[quantity.probe];
}

double end_time(const Setup& setup) {
  return prepare(setup.scene, setup.solver).chain->stops.back();
}

}  // namespace plastica::sweeps
