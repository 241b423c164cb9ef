#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "plastica/model/material.hpp"
#include "plastica/model/place.hpp"
#include "plastica/model/section.hpp"

namespace plastica {

/// Shape of the undeformed axis. It starts at the origin along z.
enum class BeamShape {
  Straight,
  Arc,       ///< a circle through `arc_angle`, towards `arc_towards`
  Polyline,  ///< over `points`
};

/// The beam's axis and how it is divided.
struct Beam {
  double length = 1.0;  ///< along the axis [m], > 0; of a polyline, the sum over its points
  int segments = 10;    ///< number of rigid segments, >= 1; l = length/segments at inner joints
  /// Length of each segment as a fraction of the beam's [1], > 0, sum 1 (segments); empty: equal.
  std::vector<double> segment_fractions{};
  /// Tributary length of each inner joint [m], > 0 (segments - 1); empty: (L_a + L_b)/2.
  std::vector<double> joint_lengths{};
  BeamShape shape = BeamShape::Straight;
  double arc_angle = 0.0;                            ///< Arc: [rad], > 0
  std::array<double, 3> arc_towards{0.0, 1.0, 0.0};  ///< Arc: unit vector across z
  std::vector<std::array<double, 3>> points{};       ///< Polyline: [m], the first is the start
};

/// A stretch of the beam that has another section or material. Later ones win.
struct Region {
  Place from{};
  Place to{1.0, {}};
  Section section{};
  Material material{};
  /// A taper: the section at `to`, of the shape of `section`, which is that at `from`; between them
  /// every dimension goes along a straight line.
  std::optional<Section> to_section{};
  /// What it says itself: paths of fields, or of groups of them, as "section.width". The rest goes
  /// with the beam's section and material when a fit or a sweep changes these: see `follow_beam`.
  std::vector<std::string> own{"section", "material", "to_section"};
};

}  // namespace plastica
