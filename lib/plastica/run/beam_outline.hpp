#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plastica/run/model.hpp"

namespace plastica {

/// Where the joints and segments of a chain's undeformed beam are and how thick it is there: what
/// is needed to draw a response and to read moments and angles of joints as stresses and strains.
/// N segments; joint i lies at segment end i, 0 … N, as in ChainHistory. Empty for a coupon.
struct BeamOutline {
  std::vector<double> ends;  ///< segment ends as fractions of the length, 0 first, 1 last (N + 1)
  std::vector<double> node;  ///< segment ends in world axes [m] (N + 1 x 3)
  /// Axes x, y, z of each segment in world axes, one after the other (N x 3 x 3).
  std::vector<double> axes;
  std::vector<double> joint_length;  ///< tributary lengths l [m] (N + 1)
  std::vector<double> width;         ///< outer size along x [m] (N)
  std::vector<double> height;        ///< outer size along y [m] (N)
  std::vector<std::uint8_t> round;   ///< 1: a circle or round tube (N)
  /// Stress of the extreme fibre = moment / modulus: W_x, W_y, W_t [m^3] (N + 1 x 3).
  std::vector<double> modulus;
  /// Strain of the extreme fibre = angle x this: (h/2)/l, (b/2)/l, (J/W_t)/l [1/rad]
  /// (N + 1 x 3).
  std::vector<double> strain_per_angle;

  std::size_t segments() const { return width.size(); }
};

BeamOutline beam_outline(const Model& model);

}  // namespace plastica
