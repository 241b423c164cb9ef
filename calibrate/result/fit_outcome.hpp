#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/inference/intervals.hpp"
#include "calibrate/problem/law.hpp"
#include "calibrate/result/fitted_parameter.hpp"

namespace plastica::calibrate {

/// How a fit ended. Ranked: a smaller one is better.
enum class FitStatus {
  Fitted,    ///< parameters found; look at the warnings
  Failed,    ///< the optimizer or the model gave nothing usable; `reason` says what
  Rejected,  ///< the target could not be fitted at all: see the target's status and reason
};

std::string_view name_of(FitStatus status);

/// What every fit says, of a specimen's curve or through scenes; can explain itself (report/).
struct FitOutcome {
  FitStatus status = FitStatus::Failed;
  std::string reason;    ///< one sentence for all but Fitted
  Law law = Law::Ideal;  ///< that was fitted; of several targets the first one's
  std::vector<FittedParameter> parameters;
  /// Of the free parameters that the curves can say something of, in their order (n x n), row by
  /// row; NaN where one is not identified, empty without a fit.
  std::vector<double> correlation;
  FitIntervals intervals;  ///< of the free parameters, in their order: those that were asked for
  /// Where laws are compared: what fits without one part of the curves leave of that part, as
  /// fractions squared (held_out.hpp) [1]; empty: not known.
  std::vector<double> held_out;
  /// Root of the mean of these [1]; NaN where they are not known.
  double held_out_misfit() const;
  std::vector<std::string> warnings;

  bool is_fitted() const { return status == FitStatus::Fitted; }
  /// The parameter of a path, or of its last part. @throws std::out_of_range
  const FittedParameter& parameter(std::string_view name) const;
  /// The same; null if there is none.
  const FittedParameter* find_parameter(std::string_view name) const;
  /// The free ones, in their order: the rows of `intervals` (n_free).
  std::vector<const FittedParameter*> free_parameters() const;
  std::size_t free_count() const;  ///< n_free
};

}  // namespace plastica::calibrate
