#pragma once

#include <array>
#include <optional>

#include "plastica/model/history.hpp"
#include "plastica/model/place.hpp"

namespace plastica {

/// A load on the beam in world axes: at a point, or spread evenly from one place to another.
struct Load {
  Place at{1.0, {}};
  std::optional<Place> to{};       ///< if set, the load is spread from `at` to here, per length
  std::array<double, 3> force{};   ///< [N], spread: [N/m]
  std::array<double, 3> moment{};  ///< [N m], spread: [N m/m]
  bool follows = false;            ///< turns with the segment that it acts on (a follower load)
  History history = History::ramp();
};

}  // namespace plastica
