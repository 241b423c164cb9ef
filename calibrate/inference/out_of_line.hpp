#pragma once

#include <cstddef>
#include <vector>

namespace plastica::calibrate {

/// Beyond this size of its score a value is out of line with the others.
inline constexpr double kOutOfLine = 3.5;
/// Of fewer values the median and the deviation from it say too little.
inline constexpr std::size_t kFewestInLine = 5;

/// How far each of a set of values lies off the others.
struct ModifiedZScores {
  double median = 0.0;
  std::vector<double> scores{};  ///< (n_values); empty: nothing can be said
};

/// The modified z-score of each value,
///   z_k = 0.6745 (v_k - m)/MAD,  m the median of v, MAD the median of |v_k - m|.
/// MAD/0.6745 estimates the standard deviation of normal values and, unlike that, hardly moves by
/// one value that is far off: up to half of all may be. The size of z is compared with
/// `kOutOfLine`. Nothing is said of fewer than `kFewestInLine` values, and none where more than
/// half of the values are the same: MAD is 0 then. A factor on all values, and a number that is
/// added to all, change no score.
/// Source: Iglewicz & Hoaglin, How to Detect and Handle Outliers (1993), 3.2.
/// @param values  finite, in any order
ModifiedZScores modified_z_scores(const std::vector<double>& values);

}  // namespace plastica::calibrate
