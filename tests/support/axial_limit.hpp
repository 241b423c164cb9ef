#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/model/section.hpp"

namespace plastica::testing {

/// How far the fillets of an I-section reach beyond a line, at a distance from where they end.
inline double fillet_at(double radius, double from_end) {
  if (from_end <= 0.0 || from_end >= radius) return 0.0;
  return radius - std::sqrt(radius * radius - from_end * from_end);
}

inline double i_section_width_at(const Section& s, double y, bool about_x) {
  const double r = s.fillet_radius;
  const double from_middle = std::fabs(y);
  if (about_x) {
    const double flange = 0.5 * s.height - s.flange_thickness;
    if (from_middle >= flange) return s.width;
    return s.web_thickness + 2.0 * fillet_at(r, from_middle - (flange - r));
  }
  const double web = 0.5 * s.web_thickness;
  if (from_middle <= web) return s.height;
  return 2.0 * (s.flange_thickness + fillet_at(r, web + r - from_middle));
}

/// Width of a section at a distance y from its middle [m], bending about x (or y).
inline double width_at(const Section& s, double y, bool about_x = true) {
  const auto chord = [&](double radius) {
    return 2.0 * std::sqrt(std::max(radius * radius - y * y, 0.0));
  };
  switch (s.shape) {
    case SectionShape::Rectangle: return about_x ? s.width : s.height;
    case SectionShape::Circle: return chord(s.radius);
    case SectionShape::RoundTube: return chord(s.radius) - chord(s.inner_radius);
    case SectionShape::RectangularTube: {
      const double wide = about_x ? s.width : s.height;
      const bool in_hole = std::fabs(y) < 0.5 * (about_x ? s.inner_height : s.inner_width);
      return wide - (in_hole ? (about_x ? s.inner_width : s.inner_height) : 0.0);
    }
    case SectionShape::ISection: return i_section_width_at(s, y, about_x);
    case SectionShape::Numbers: break;
  }
  return 0.0;
}

/// The moment of a fully plastic section beside n = |N|/N_p, over that without, by strips: those
/// within the neutral axis and its mirror image carry N, those beyond it the moment.
inline double plastic_moment_left(const Section& s, double n, bool about_x = true) {
  constexpr int kStrips = 100000;
  const bool round = s.shape == SectionShape::Circle || s.shape == SectionShape::RoundTube;
  const double half = round ? s.radius : 0.5 * (about_x ? s.height : s.width);
  const double dy = half / kStrips;
  double area = 0.0;
  double all = 0.0;
  for (int i = 0; i < kStrips; ++i) {
    const double y = (i + 0.5) * dy;
    area += width_at(s, y, about_x) * dy;
    all += width_at(s, y, about_x) * y * dy;
  }
  double pulled = 0.0;
  double left = all;
  for (int i = 0; i < kStrips && pulled < n * area; ++i) {
    const double y = (i + 0.5) * dy;
    const double strip = width_at(s, y, about_x) * dy;
    const double part = std::min(1.0, (n * area - pulled) / strip);
    pulled += part * strip;
    left -= part * strip * y;
  }
  return left / all;
}

}  // namespace plastica::testing
