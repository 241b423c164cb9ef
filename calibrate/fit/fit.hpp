#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/search/ladder.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/next_index.hpp"

namespace plastica::calibrate {

/// Refuses what no target could be fitted with: parameters that no law of the fit has, bounds out
/// of range, a comparison with multilinear hardening without a table.
/// @throws InputError
void check_fit_options(const FitOptions& options);

/// Fits one target, with the law of the options' material. Never throws for what a curve is like:
/// that is a status of the result.
/// @throws FitInterrupted once the options' `stop` is raised
/// @throws InputError if the options themselves are bad (parameters that no coupon has, an unknown
///         algorithm, `check_fit_options`)
/// @param further  where the search begins besides the start of the parameters
FitResult fit_target(const Target& target, const FitOptions& options,
                     std::span<const StartPoint> further = {});

struct BatchFitOptions {
  int threads = 0;  ///< 0: as many as the machine has
  /// Once raised, no further fit is begun, and those under way end at their next evaluation and
  /// count as not begun. May be null.
  StopFlag stop = nullptr;
  /// Called after each fit with its index, one call at a time, from any thread: journal, progress.
  /// It may put the result's curve aside.
  std::function<void(std::size_t index, FitResult& result)> finished;
  /// Which fits are to be done, see `ParallelOptions`. Empty: all.
  NextIndex next{};
};

/// One fit of a batch: of a target, with one of the laws that are compared.
struct FitCase {
  std::size_t target = 0;  ///< index
  std::optional<Law> law;  ///< empty: the options' own
};

/// All fits of targets with these options: every law of the first target, then of the next.
std::vector<FitCase> cases_of(std::size_t targets, const FitOptions& options);

/// Most fits of a run whose evaluations are stored one by one.
inline constexpr std::size_t kTracedFits = 100;

/// Fits cases in parallel, as `fit`. Result i belongs to case i.
std::vector<FitResult> fit_cases(std::span<const Target> targets, std::span<const FitCase> cases,
                                 const FitOptions& options, const BatchFitOptions& batch = {});

/// Fits targets in parallel, each with every law (`cases_of`). Without laws result i belongs to
/// target i and has the same bits for every number of threads and every order of the targets. A fit
/// that was not begun has the reason "not run".
std::vector<FitResult> fit(std::span<const Target> targets, const FitOptions& options,
                           const BatchFitOptions& batch = {});

}  // namespace plastica::calibrate
