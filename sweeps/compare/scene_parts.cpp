#include "sweeps/compare/scene_parts.hpp"

#include "plastica/run/chain_model.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::sweeps {
namespace {

bool is_at(const Place& place, double fraction, const Setup& setup) {
  const int segments = setup.scene.beam.segments;
  if (place.segment) return *place.segment == (fraction == 0.0 ? 0 : segments);
  return place.fraction == fraction;
}

}  // namespace

void require_scene(bool holds, std::string_view rule) {
  if (!holds) throw InputError({}, "", "", rule);
}

Cantilever cantilever_of(const Setup& setup) {
  const Scene& scene = setup.scene;
  require_scene(!scene.is_coupon() && scene.supports.size() == 1 &&
                    scene.supports[0].kind == SupportKind::Clamp && !scene.supports[0].hold &&
                    !scene.supports[0].moves() && is_at(scene.supports[0].at, 0.0, setup),
                "is for a beam with a clamp at its start as its one support");
  require_scene(scene.beam.shape == BeamShape::Straight && scene.regions.empty(),
                "is for a straight, even beam");
  const bool weightless = scene.gravity == std::array<double, 3>{};
  require_scene(scene.loads.size() == 1 && !scene.loads[0].to && !scene.loads[0].follows &&
                    is_at(scene.loads[0].at, 1.0, setup) && weightless,
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

const Probe& end_probe(const Setup& setup, const Quantity& quantity) {
  require_scene(quantity.kind == QuantityKind::Probe && quantity.take == Take::End,
                "is for a probe at the end of the run");
  return setup.scene.probes[quantity.probe];
}

double end_time(const Setup& setup) {
  return prepare(setup.scene, setup.solver).chain->stops.back();
}

}  // namespace plastica::sweeps
