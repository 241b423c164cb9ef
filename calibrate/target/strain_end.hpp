#pragma once

#include <cstddef>

#include "calibrate/target/curve.hpp"

/// Records whose strain ends before their load; not installed.
namespace plastica::calibrate {

/// Of the largest stress: what is left after a break is no load.
inline constexpr double kLoaded = 0.2;

/// How the strain of a record ends.
struct StrainEnd {
  /// From this row on the strain is none: the extensometer was taken off, set to zero or clamped,
  /// and its value was recorded on. As many as there are rows: it is measured to the end.
  std::size_t measured = 0;
  /// How many rows under load have one strain to the end, where the load does not tell whether it
  /// was measured; 0 of few, where it tells, and where a pause before was as long.
  std::size_t unclear = 0;
  double still = 0.0;   ///< the strain of those rows [1] …
  double within = 0.0;  ///< … to both sides
};

/// Looks for an end of 8 rows or more in which the strain stands still, or is noise about one
/// value, while the load goes on: it moves by more than 2 % of the largest, over more rows than
/// ever stood still before under a load that rose (the step of a coarse strain), or it rises at
/// all, as it does at no strain that is held, over 20 rows or more and three times as many. A break
/// is no such end: its load falls within few rows. A few
/// rows that are far off, or no numbers, do not count.
StrainEnd strain_end(const Curve& raw);

}  // namespace plastica::calibrate
