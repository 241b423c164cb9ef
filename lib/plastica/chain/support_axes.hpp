#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "plastica/chain/rotation.hpp"
#include "plastica/model/support_kind.hpp"

/// Rotations that a support holds or springs, about the axes of the joint where it is. A scene
/// names them about the world's axes; a joint has its own, which turn with the beam.
namespace plastica::chain {

/// Axes that are off by no more are taken as not skew [rad].
inline constexpr double kNotSkew = 1e-5;

/// @param frame  of the joint, columns x, y, z
/// @return empty where the held axes lie skew to the joint's: about some axis of it the support
///         would hold half. What a kind holds of its own, as a pin the twist, is about the joint's
///         axes.
inline std::optional<std::array<bool, 3>> held_rotations(const Support& support,
                                                         const Mat<double, 3, 3>& frame) {
  const HeldFreedoms held = support.held();
  std::array<bool, 3> own{held[3], held[4], held[5]};
  if (held == traits_of(support).held) return own;
  for (std::size_t k = 0; k < 3; ++k) {
    double part = 0.0;
    for (std::size_t w = 0; w < 3; ++w) part += held[3 + w] ? frame(w, k) * frame(w, k) : 0.0;
    if (part > kNotSkew * kNotSkew && part < 1.0 - kNotSkew * kNotSkew) return std::nullopt;
    own[k] = part > 0.5;
  }
  return own;
}

/// @return [N m/rad]; empty where the springs' axes lie skew to the joint's, whose springs are
///         about its own axes
inline std::optional<std::array<double, 3>> rotational_springs(const Support& support,
                                                               const Mat<double, 3, 3>& frame) {
  const std::array<double, 3>& of_world = support.rotational_stiffness;
  const double largest = *std::max_element(of_world.begin(), of_world.end());
  std::array<double, 3> own{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (std::size_t w = 0; w < 3; ++w) sum += frame(w, i) * of_world[w] * frame(w, j);
      if (i == j) {
        own[i] = sum > kNotSkew * kNotSkew * largest ? sum : 0.0;
      } else if (std::fabs(sum) > kNotSkew * largest) {
        return std::nullopt;
      }
    }
  }
  return own;
}

}  // namespace plastica::chain
