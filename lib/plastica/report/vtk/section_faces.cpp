#include "plastica/report/vtk/section_faces.hpp"

#include <cmath>
#include <numbers>

#include "plastica/model/section_kind.hpp"

namespace plastica::report {
namespace {

constexpr std::size_t kSides = 16;  ///< of a circle; even, so that four corners make up its faces

void add_rectangle(double x0, double x1, double y0, double y1, SectionFaces& made) {
  const std::size_t n = made.corners.size();
  made.corners.insert(made.corners.end(), {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  for (std::size_t k = 0; k < 4; ++k) made.edges.push_back({n + k, n + (k + 1) % 4});
  made.faces.push_back({n, n + 1, n + 2, n + 3});
}

/// A block of a quarter in all four, as one where it reaches an axis.
void add_block(const SectionBlock& block, SectionFaces& made) {
  const auto sides = [](double from, double to) -> std::vector<std::array<double, 2>> {
    if (from <= 0.0) return {{-to, to}};
    return {{-to, -from}, {from, to}};
  };
  for (const auto& [x0, x1] : sides(block.x_from, block.x_to)) {
    for (const auto& [y0, y1] : sides(block.y_from, block.y_to)) {
      add_rectangle(x0, x1, y0, y1, made);
    }
  }
}

void add_ring(double radius, SectionFaces& made) {
  for (std::size_t k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kSides;
    made.corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
}

SectionFaces round_faces(double radius, double hole) {
  SectionFaces made;
  add_ring(radius, made);
  const auto next = [](std::size_t k) { return (k + 1) % kSides; };
  for (std::size_t k = 0; k < kSides; ++k) made.edges.push_back({k, next(k)});
  if (hole > 0.0) {
    add_ring(hole, made);
    for (std::size_t k = 0; k < kSides; ++k) {
      made.edges.push_back({kSides + next(k), kSides + k});
      made.faces.push_back({k, next(k), kSides + next(k), kSides + k});
    }
  } else {
    // Strips from one side to the other.
    for (std::size_t k = 0; k + 1 < kSides / 2; ++k) {
      made.faces.push_back({k, k + 1, kSides - 2 - k, kSides - 1 - k});
    }
  }
  return made;
}

}  // namespace

SectionFaces section_faces(const Section& section) {
  const SectionKind& kind = section_kind(section);
  const SectionProperties properties = section_properties(section, 0.3);
  if (kind.round()) return round_faces(properties.outer_distance_y, kind.hole_radius(section));
  SectionFaces made;
  if (const auto quarter = kind.quarter(section)) {
    for (const SectionBlock& block : quarter->blocks) add_block(block, made);
  } else {
    add_block({0.0, properties.outer_distance_y, 0.0, properties.outer_distance_x}, made);
  }
  return made;
}

}  // namespace plastica::report
