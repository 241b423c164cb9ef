#pragma once

#include <cstdlib>
#include <string>

namespace plastica::testing {

/// A test's tolerance times the environment variable PLASTICA_TOLERANCE_SCALE (1 by default):
/// with 0 every comparison fails and so shows its true residual.
inline double tolerance(double value) {
  const char* scale = std::getenv("PLASTICA_TOLERANCE_SCALE");
  return scale == nullptr ? value : value * std::stod(scale);
}

}  // namespace plastica::testing
