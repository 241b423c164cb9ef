#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/run/response.hpp"
#include "plastica/run/response_size.hpp"

namespace plastica {

/// One array of a frame, and how many numbers it has.
struct ShapeValue {
  std::vector<double> ChainHistory::*values;
  std::size_t of_joint = 0, of_segment = 0, of_support = 0;
  bool of_motion = false;  ///< whether a path at rest has none

  std::size_t count(const ResponseSize& size) const {
    if (of_motion && !size.in_motion) return 0;
    return of_joint * (size.segments + 1) + of_segment * size.segments + of_support * size.supports;
  }
};

/// What a frame of a chain's history consists of.
inline constexpr std::array<ShapeValue, 11> kShapeValues{{{&ChainHistory::position, 3},
                                                          {&ChainHistory::moment, 3},
                                                          {&ChainHistory::force, 3},
                                                          {&ChainHistory::angle, 3},
                                                          {&ChainHistory::plastic_angle, 3},
                                                          {&ChainHistory::rotation, 0, 3},
                                                          {&ChainHistory::plastic_strain, 1},
                                                          {&ChainHistory::stress, 1},
                                                          {&ChainHistory::reaction, 0, 0, 6},
                                                          {&ChainHistory::velocity, 0, 3, 0, true},
                                                          {&ChainHistory::spin, 0, 3, 0, true}}};

/// Makes room for so many frames, with zeros.
inline void size_shape(const ResponseSize& size, std::size_t frames, ChainHistory& history) {
  history.joints = size.segments + 1;
  history.supports = size.supports;
  for (const ShapeValue& value : kShapeValues) {
    (history.*value.values).assign(frames * value.count(size), 0.0);
  }
}

}  // namespace plastica
