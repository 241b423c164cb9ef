#include "plastica/model/local_buckling.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "plastica/model/section_kind.hpp"

namespace plastica::model_detail {
namespace {

/// Limits of the classes 1, 2 and 3.
using Limits = std::array<double, 3>;
constexpr Limits kRound{50.0, 70.0, 90.0};
constexpr Limits kCompressed{33.0, 38.0, 42.0};
constexpr Limits kBent{72.0, 83.0, 124.0};
constexpr Limits kOutstand{9.0, 10.0, 14.0};

WallClass class_of(const SectionWall& wall, std::string_view ratio, const Limits& limits,
                   double unit) {
  WallClass found{1, ratio, wall.slenderness, limits[0] * unit};
  while (found.section_class < 4 &&
         wall.slenderness > limits[static_cast<std::size_t>(found.section_class - 1)] * unit) {
    found.limit = limits[static_cast<std::size_t>(found.section_class - 1)] * unit;
    ++found.section_class;
  }
  return found;
}

}  // namespace

std::optional<WallClass> worst_wall(const Section& section, const Material& material, bool about_x,
                                    bool about_y) {
  const double square = 235e6 / material.yield_stress * material.youngs_modulus / 210e9;
  std::optional<WallClass> worst;
  for (const SectionWall& wall : section_kind(section).walls(section)) {
    const bool compressed = (about_x && wall.compressed[0]) || (about_y && wall.compressed[1]);
    WallClass found;
    switch (wall.kind) {
      case SectionWall::Kind::Round: found = class_of(wall, "d/t", kRound, square); break;
      case SectionWall::Kind::Internal:
        found = class_of(wall, "c/t", compressed ? kCompressed : kBent, std::sqrt(square));
        break;
      case SectionWall::Kind::Outstand:
        found = class_of(wall, "c/t", kOutstand, std::sqrt(square));
        break;
    }
    if (!worst || found.section_class > worst->section_class) worst = found;
  }
  return worst;
}

}  // namespace plastica::model_detail
