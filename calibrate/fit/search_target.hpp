#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "calibrate/fit/options.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/problem/weighed_priors.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/ladder.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// How much is said of a fit: all (explain_fit.hpp), or what a search goes on from.
enum class Told : std::uint8_t { All, ForSearch };

/// Fits one target, without priors and without what the options ask for beside a fit
/// (IntervalOptions). Parameters and errors as `fit_target`, whose options are checked.
/// @param searched  gets the misfit, if there was one to search; null: nobody goes on with it
FitResult search_target(const Target& target, const FitOptions& options, Told told,
                        std::span<const StartPoint> further = {},
                        std::optional<Misfit>* searched = nullptr);

/// The priors of a fit: those that parameters state, and that of the elastic slope of its curve;
/// none where there is nothing to fit.
struct FitPriors {
  FitPriors(const Target& target, const FitOptions& options);
  /// Of the search without them, which `weigh_priors` follows.
  Told told() const { return all.all.empty() ? Told::All : Told::ForSearch; }

  std::optional<ModulusPrior> slope;
  WeighedPriors all;
};

/// Weighs a fit with its priors: searches on from its values with them, until their variance no
/// longer changes, and says all of it. Leaves a result that is not Fitted, or has no prior, as it
/// is.
/// @param options   those that it was searched with
/// @param misfit    that was searched, to go on with
void weigh_priors(const Target& target, const FitOptions& options, const FitPriors& priors,
                  Misfit& misfit, FitResult& result);

}  // namespace plastica::calibrate
