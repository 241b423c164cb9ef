#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "sweeps/store/sweep_record.hpp"

/// What is said of a sweep of so many cases that nobody reads their rows; not installed.
namespace plastica::sweeps {

/// The quantile of sorted numbers, straight between neighbours: that at the place q (n - 1).
/// @param sorted  rising (n >= 1)
/// @param q       0 … 1
double quantile(std::span<const double> sorted, double q);

/// Spearman's rank correlation: Pearson's of the ranks, of equal numbers their mean rank.
/// Source: Spearman, Am. J. Psychol. 15 (1904) 72.
/// @param x, y  (n each)
/// @return -1 … 1; none where one of them does not vary
std::optional<double> rank_correlation(std::span<const double> x, std::span<const double> y);

/// Least, quartiles and largest of axes, values and errors, how the values go with each axis, and
/// the orders of the groups; then the cases that failed, by status, with the first reasons.
std::string spread_report(const SweepRecord& record);

}  // namespace plastica::sweeps
