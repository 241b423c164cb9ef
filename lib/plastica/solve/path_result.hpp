#pragma once

namespace plastica {

/// How a path was walked.
struct PathCounters {
  int steps = 0;       ///< converged, recorded or not
  int iterations = 0;  ///< Newton iterations, those of failed steps included
  int cutbacks = 0;    ///< steps that were tried again shorter
};

/// The load factor between whose ends the last equilibrium lies [1]; set with Status::LimitLoad.
struct LimitLoad {
  double below = 0.0;  ///< equilibrium was found here
  double above = 0.0;  ///< and none here
};

}  // namespace plastica
