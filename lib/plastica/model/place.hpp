#pragma once

#include <optional>

namespace plastica {

/// A material point on the beam's axis, by its distance from the start along the axis.
struct Place {
  double fraction = 0.0;  ///< of the length [1], 0 (start) … 1 (end)
  std::optional<int>
      segment{};  ///< if set, the outer end of this segment: 0 is the start, N the end

  static Place start() { return {0.0, {}}; }
  static Place end() { return {1.0, {}}; }
};

}  // namespace plastica
