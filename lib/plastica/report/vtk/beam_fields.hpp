#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "plastica/run/response.hpp"

namespace plastica::report {

/// A quantity of joints that a file for ParaView has; not installed.
struct JointQuantity {
  std::string_view name;
  std::string_view unit;
  std::size_t components = 1;  ///< 3: about or along x, y, z of the joint
  const std::vector<double>& (*values)(
      const ChainHistory& chain);  ///< (frames x joints x components)
};

inline constexpr std::array<JointQuantity, 5> kJointQuantities{{
    {"moment", "N m", 3,
     [](const ChainHistory& c) -> const std::vector<double>& { return c.moment; }},
    {"force", "N", 3, [](const ChainHistory& c) -> const std::vector<double>& { return c.force; }},
    {"plastic_angle", "rad", 3,
     [](const ChainHistory& c) -> const std::vector<double>& { return c.plastic_angle; }},
    {"plastic_strain", "1", 1,
     [](const ChainHistory& c) -> const std::vector<double>& { return c.plastic_strain; }},
    {"stress", "Pa", 1,
     [](const ChainHistory& c) -> const std::vector<double>& { return c.stress; }},
}};

}  // namespace plastica::report
