#pragma once

#include <string>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_result.hpp"

namespace plastica::calibrate {

/// Why parameters that were found are of no use, in a sentence; empty if they may be. Beyond
/// - a misfit of half of the largest measured ordinate: the model does not follow the curve;
/// - one free parameter that ended at a bound: the optimum lies elsewhere. Not counted are a lower
///   bound of 0, a fraction of kinematic hardening, and the break of a curve that does not break:
///   they may end there.
std::string why_unusable(const FitResult& result);
/// The same of the target with the largest misfit.
std::string why_unusable(const SceneFitResult& result);

/// Why the value of one parameter is no answer: it was fixed, the curves do not identify it, or it
/// ended at a bound, beyond which the optimum lies (0 is where many numbers end). Empty: it is one.
std::string why_no_answer(const FittedParameter& parameter);

/// Whether a fit succeeded and may be used.
template <typename Result>
bool is_usable(const Result& result) {
  return result.is_fitted() && why_unusable(result).empty();
}

}  // namespace plastica::calibrate
