#include "plastica/model/local_buckling.hpp"

#include <array>
#include <cmath>

namespace plastica::model_detail {
namespace {

/// Limits of the classes 1, 2 and 3.
using Limits = std::array<double, 3>;
constexpr Limits kRound{50.0, 70.0, 90.0};
constexpr Limits kCompressed{33.0, 38.0, 42.0};
constexpr Limits kBent{72.0, 83.0, 124.0};

TubeWall wall_of(double slenderness, const Limits& limits, double unit) {
  TubeWall wall{1, slenderness, limits[0] * unit};
  while (wall.section_class < 4 &&
         slenderness > limits[static_cast<std::size_t>(wall.section_class - 1)] * unit) {
    wall.limit = limits[static_cast<std::size_t>(wall.section_class - 1)] * unit;
    ++wall.section_class;
  }
  return wall;
}

}  // namespace

std::optional<TubeWall> tube_wall(const Section& section, const Material& material, bool about_x,
                                  bool about_y) {
  const double square = 235e6 / material.yield_stress * material.youngs_modulus / 210e9;
  if (section.shape == SectionShape::RoundTube) {
    const double slenderness = 2.0 * section.radius / (section.radius - section.inner_radius);
    return wall_of(slenderness, kRound, square);
  }
  if (section.shape != SectionShape::RectangularTube) return std::nullopt;
  const double unit = std::sqrt(square);
  // Walls across y lie along x, and bending about x compresses one of them evenly.
  const double along_x = section.inner_width / (0.5 * (section.height - section.inner_height));
  const double along_y = section.inner_height / (0.5 * (section.width - section.inner_width));
  TubeWall worst = wall_of(along_x, about_x ? kCompressed : kBent, unit);
  const TubeWall other = wall_of(along_y, about_y ? kCompressed : kBent, unit);
  if (other.section_class > worst.section_class) worst = other;
  return worst;
}

}  // namespace plastica::model_detail
