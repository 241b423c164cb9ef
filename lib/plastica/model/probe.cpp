#include "plastica/model/probe.hpp"

#include <array>

namespace plastica {

std::span<const std::string_view> probe_kinds() {
  static constexpr std::array<std::string_view, 16> kWords{
      "strain",        "stress",          "plastic_strain", "accumulated_strain",
      "load",          "dissipation",     "displacement",   "rotation",
      "reaction",      "reaction_moment", "moment",         "angle",
      "plastic_angle", "force",           "load_factor",    "energy"};
  return kWords;
}

}  // namespace plastica
