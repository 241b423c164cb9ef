#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/model/section.hpp"

namespace plastica::testing {

/// Width of a section at a distance y from its middle [m], bending about x.
inline double width_at(const Section& s, double y) {
  const auto chord = [&](double radius) {
    return 2.0 * std::sqrt(std::max(radius * radius - y * y, 0.0));
  };
  switch (s.shape) {
    case SectionShape::Rectangle: return s.width;
    case SectionShape::Circle: return chord(s.radius);
    case SectionShape::RoundTube: return chord(s.radius) - chord(s.inner_radius);
    case SectionShape::RectangularTube:
      return s.width - (std::fabs(y) < 0.5 * s.inner_height ? s.inner_width : 0.0);
  }
  return 0.0;
}

/// The moment of a fully plastic section beside n = |N|/N_p, over that without, by strips: those
/// within the neutral axis and its mirror image carry N, those beyond it the moment.
inline double plastic_moment_left(const Section& s, double n) {
  constexpr int kStrips = 100000;
  const bool round = s.shape == SectionShape::Circle || s.shape == SectionShape::RoundTube;
  const double half = round ? s.radius : 0.5 * s.height;
  const double dy = half / kStrips;
  double area = 0.0;
  double all = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    const double y = (i + 0.5) * dy;
    area += width_at(s, y) * dy;
    all += width_at(s, y) * y * dy;
  }
  double pulled = 0.0;
  double left = all;
  for (int i = 0; i < kStrips && pulled < n * area; ++i) {
    const double y = (i + 0.5) * dy;
    const double strip = width_at(s, y) * dy;
    const double part = std::min(1.0, (n * area - pulled) / strip);
    pulled += part * strip;
    left -= part * strip * y;
  }
  return left / all;
}

}  // namespace plastica::testing
