#pragma once

#include <limits>

namespace plastica::calibrate {

/// Stands where there is no number.
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace plastica::calibrate
