#pragma once

#include <optional>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/run/response.hpp"

namespace plastica::calibrate {

/// The fitted model on a specimen's strain path, see `FitResult::fitted`.
struct FittedCurve {
  Curve curve;
  std::optional<BreakEvent> event;  ///< its break
};

/// @param target  with the samples of its corrected curve
/// @param options  of the fit: with the law in its material
/// @param result  has the parameters
FittedCurve fitted_curve(const Target& target, const FitOptions& options, const FitResult& result);

/// The curve of a result that only counts its samples (`Curve::aside`), as large batches do: the
/// same bits as the fit gave it. Empty where there are none.
/// @param target  wherever its samples are
/// @param options  of the batch, which may compare laws
/// @throws io::StorageError
Curve remade_curve(const Target& target, const FitOptions& options, const FitResult& result);

/// Whether a result's curve may have as many samples as it counts.
bool may_have_curve(const Target& target, const FitResult& result);

/// Lets a result only count the samples of its curve.
void count_alone(FitResult& result);

}  // namespace plastica::calibrate
