#include "plastica/model/numbered_place.hpp"

#include "plastica/model/beam_axis.hpp"

namespace plastica {

std::optional<std::string_view> numbered_place(const Scene& scene, const SolverOptions& solver) {
  std::optional<std::string_view> found;
  const auto look = [&](const std::optional<Place>& place, std::string_view what) {
    if (!found && place && place->segment.value_or(0) != 0) found = what;
  };
  look(solver.control_at, "solver.control_at");
  for (const Region& one : scene.regions) {
    look(one.from, "region.from");
    look(one.to, "region.to");
  }
  for (const Support& one : scene.supports) {
    look(one.at, "support.at");
    look(one.to, "support.to");
  }
  for (const Load& one : scene.loads) {
    look(one.at, "load.at");
    look(one.to, "load.to");
  }
  for (const PointMass& one : scene.masses) look(one.at, "mass.at");
  for (const Probe& one : scene.probes) look(one.at, "probe.at");
  for (const Cut& one : scene.cuts) look(one.at, "cut.at");
  for (const InitialMotion& one : scene.initial_motions) {
    look(one.from, "initial_motion.from");
    look(one.to, "initial_motion.to");
    look(one.about, "initial_motion.about");
  }
  return found;
}

namespace {

std::string moved(std::string_view place) {
  return "moves the scene's " + std::string(place) +
         ", the end of a segment by its number: give it as a fraction";
}

}  // namespace

std::string why_not_segments(const Scene& scene, const SolverOptions& solver, int segments) {
  const auto place = numbered_place(scene, solver);
  return place && segments != scene.beam.segments ? moved(*place) : "";
}

std::string why_not_beam(const Scene& scene, const SolverOptions& solver, const Scene& other) {
  const auto place = numbered_place(scene, solver);
  return place && segment_ends(scene) != segment_ends(other) ? moved(*place) : "";
}

}  // namespace plastica
