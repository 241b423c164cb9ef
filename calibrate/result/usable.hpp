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

/// Whether a fit succeeded and may be used.
template <typename Result>
bool is_usable(const Result& result) {
  return result.is_fitted() && why_unusable(result).empty();
}

}  // namespace plastica::calibrate
