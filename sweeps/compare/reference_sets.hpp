#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

/// Which cases share a reference; not installed.
namespace plastica::sweeps {

/// The cases of one problem: they differ in axes that refine alone.
struct ReferenceSet {
  std::vector<std::size_t> cases{};    ///< by rising number; of equal runs the first alone
  std::vector<std::size_t> numbers{};  ///< axes of numbers that refine and vary among the cases
  std::vector<std::size_t> words{};    ///< axes of words that refine and vary among the cases
  /// Axes of numbers that refine and vary in the sweep, but not among these cases.
  std::vector<std::size_t> held{};
  /// The case that is finest in all of `numbers` and `words`, of those that have a value.
  std::optional<std::size_t> finest{};
};

/// All cases by problem, with how fine each is.
struct ReferenceSets {
  std::vector<ReferenceSet> sets{};
  std::vector<std::size_t> set_of{};   ///< number of each case's set (n_cases)
  std::vector<std::size_t> same_as{};  ///< first case of the same set and run (n_cases)
  std::size_t axes = 0;
  std::vector<double> size{};     ///< h of each case on each axis, see size_on (n_cases x n_axes)
  std::vector<bool> is_finest{};  ///< whether its word is one of the finest (n_cases x n_axes)

  double size_at(std::size_t index, std::size_t axis) const { return size[index * axes + axis]; }
  bool finest_word_at(std::size_t index, std::size_t axis) const {
    return is_finest[index * axes + axis];
  }
};

/// Whether two sizes are one, but for rounding.
bool same_size(double a, double b);

/// Whether a case has something that others may be compared with: a run that is not balanced has
/// not.
bool has_outcome(const CaseResult& result);

/// The size of what an axis refines, as a run takes it: a ratio rounded to whole segments, a step
/// cut to the samples. NaN for other axes, and for values that are no measure (step_error = 0).
double size_on(const Axis& axis, const Setup& setup);

/// @param ids  of the runs: cases with the same are one run; empty: none are (n_cases)
ReferenceSets reference_sets(const Sweep& sweep, const CaseTable& cases,
                             const std::vector<CaseResult>& results,
                             std::span<const std::string> ids);

}  // namespace plastica::sweeps
