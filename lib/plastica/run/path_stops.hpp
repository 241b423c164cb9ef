#pragma once

#include <vector>

#include "plastica/model/scene.hpp"

namespace plastica {

/// Where the steps of a path or motion must end.
struct PathStops {
  std::vector<double> time;    ///< rising; the last is the end [s]
  std::vector<bool> recorded;  ///< which of them are samples
};

/// The samples, evenly spaced, and the corners of histories and the cuts between them.
PathStops path_stops(const Scene& scene, const SolverOptions& options);

/// What a motion's fixed steps come to: each interval from one stop to the next is divided evenly,
/// into no steps longer than `solver.time_step`.
struct FixedSteps {
  double longest = 0.0;  ///< [s]
  double count = 0.0;    ///< of steps in all
  double samples = 0.0;  ///< from one sample to the next [s]
};
FixedSteps fixed_steps(const PathStops& stops, double time_step);

/// `solver.time_step` as a motion takes it: its longest step where steps are fixed. Two scenes that
/// differ in nothing else, and have the same, are one run.
double taken_time_step(const Scene& scene, const SolverOptions& options);

}  // namespace plastica
