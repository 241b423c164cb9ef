#pragma once

#include <optional>
#include <string_view>

#include "plastica/base/quantity.hpp"

/// What udunits2 reads in a unit, and our files do not mean; not installed.
namespace plastica::io {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Whether a unit has a number that is no power, a percent sign within, or an offset. To
/// udunits2 "MPa 2" and "MPa (2)" are twice as much, "MPa @ 20" begins at 20 MPa, and "GPa 5%" is a
/// twentieth: slips, in our files.
bool has_factor(std::string_view text);

/// Whether a unit has a bracket without its other half, or a sum: udunits2 reads "N)" as N, and
/// "N+1" as N.
bool is_torn(std::string_view text);

/// A power of ten, but for 1, that a text begins with: "10", "x10", "10 x", "10^3", "1e-3", "0.1".
struct Factor {
  bool multiplies = false;       ///< says so by a sign of multiplication
  bool of_what_follows = false;  ///< the sign stands behind it: "10*Force"
  bool is_power = false;         ///< is written with an exponent
  std::string_view behind{};     ///< what stands behind it, without blanks
};
/// Empty if it begins with none. Other numbers are none: "20 degC" and "50 mm" say of what a curve
/// is, "X10" is an axis.
std::optional<Factor> factor_at(std::string_view text);

/// Whether a unit has a word that is a number to udunits2 and none to us: "GPa deg" is no stress.
/// Angles are in units of what turns alone; a frequency is never an angular velocity.
bool has_wrong_word(std::string_view text, Dimension dimension);

}  // namespace plastica::io
