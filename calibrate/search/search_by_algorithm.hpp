#pragma once

#include <cstdint>
#include <string_view>

#include "calibrate/problem/scene_problem.hpp"
#include "calibrate/search/search_record.hpp"

namespace plastica::calibrate {

/// How one algorithm alone searches.
struct AlgorithmOptions {
  std::string_view name;  ///< of `algorithm_names()`, but "auto" and "gauss-newton"
  /// Largest number of points, those of slopes included; at least 2 (n + 1).
  int evaluations = 200;
  double tolerance = 1e-9;
  std::uint64_t seed = 1;
};

/// The least sum of squares of a fit through scenes by one of NLopt's algorithms alone, over the
/// whole box and from the problem's start. Slopes are forward differences, whose runs go side by
/// side; a point without curves is a very bad one.
/// @throws FitInterrupted by the problem's hooks
SearchRecord search_by_algorithm(SceneProblem& problem, const AlgorithmOptions& options);

/// Goes on from where Gauss and Newton's steps have stopped, past kinks (pass_kinks.hpp), if the
/// central slopes there promise more than a millionth of the cost: where segments or fibres yield
/// one after the other the sum of squares has kinks, at which those steps are refused.
/// @param from  best point of a search
/// @param options  `name` does not count
/// @return what it found, or `from` itself; with the runs that it took
SearchRecord search_past_kinks(SceneProblem& problem, const LeastSquares& from,
                               const AlgorithmOptions& options);

}  // namespace plastica::calibrate
