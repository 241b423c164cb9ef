#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "plastica/base/matrix.hpp"
#include "plastica/law/gauge_form.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::chain {

/// A region of the beam: the section and the material that it has there, and what follows from
/// them. A taper has one for each section.
struct BeamRegion {
  /// 0: what the scene has at its top; else the number of the `Region` that it is of, from 1.
  std::size_t scene_region = 0;
  Section section{};
  Material material{};
  SectionProperties properties{};
  law::SectionForm form{};
  law::GaugeForm gauge{};  ///< of a yield model with one surface, where the level yields on one

  double line_mass() const { return material.density * properties.area; }  ///< [kg/m]
};

/// The regions of a segment: those of the last `Region` that holds its middle, or the scene's own.
/// In a taper each segment has the section of its middle, and each joint that of its place.
struct SegmentRegions {
  std::size_t middle = 0;
  std::size_t inner = 0;  ///< as its joints see it
  std::size_t outer = 0;
  bool operator==(const SegmentRegions&) const = default;
};

/// Where the segments and joints of a scene's undeformed beam are, in space whatever the level.
///
/// Nodes are the segment ends; a node inside of the beam is a joint. The chord between two nodes of
/// an arc or over a corner is a segment's arm; its length along the axis is what joints and loads
/// go by.
struct Layout {
  std::vector<double> ends;          ///< of segments, as fractions of the length (N + 1)
  std::vector<Vec<double, 3>> node;  ///< [m] (N + 1)
  std::vector<Mat<double, 3, 3>> segment_frame;  ///< columns x, y, z; z along the chord (N)
  /// Half way between the frames of its segments; at the ends of an arc, of its tangent (N + 1).
  std::vector<Mat<double, 3, 3>> joint_frame;
  std::vector<double> segment_length;  ///< along the axis [m] (N)
  std::vector<double> joint_length;    ///< tributary lengths l [m] (N + 1)
  /// What of these lies in the segment before the node [m] (N + 1).
  std::vector<double> length_before;
  /// Half of the segment at the start, and at the end, where no joint at the end strains it, so
  /// that the next one does [m], for bending about x, about y and twist: where a moment, a
  /// rotational spring or the inertia of a point mass acts on the end and nothing holds its
  /// rotation. 0 where there is no need, or the end rule sees to it.
  std::array<std::array<double, 3>, 2> bare_half{};
  /// Whether a moment, or a force along the beam, may act on the start, and on the end, whose half
  /// segment the next joint stands for: in a taper that has the weaker of its own section and the
  /// end's.
  std::array<bool, 2> bears{};
  /// Of the length over which a joint stretches and shears, what lies before and beyond its node
  /// [m] (N + 1). The joints next to the ends have the ends' halves. A support within the beam that
  /// holds rigidly acts on the segment before its node: the half before it is the joint's before,
  /// if there is one within the beam.
  std::vector<double> shift_before;
  std::vector<double> shift_beyond;
  EndRule end_rule = EndRule::HalfJoint;  ///< never Auto
  /// Of a polyline, whose segments are straight up to a corner. The chords of an arc are not, and
  /// its joints follow it.
  bool has_corners = false;

  std::vector<BeamRegion> regions;              ///< the scene's own, its regions', those of tapers
  std::vector<SegmentRegions> segment_regions;  ///< numbers of regions (N)

  std::size_t size() const { return segment_length.size(); }
};

/// A point of the beam on its segment.
struct SegmentPoint {
  std::size_t segment = 0;
  Vec<double, 3> arm{};  ///< from the inner joint, in the segment's frame [m]
};

/// Lays out a scene that has passed `check_scene`. Tributary lengths are (L_a + L_b)/2 or as the
/// scene gives them; half the end segment at the ends, where a half joint may be; with
/// EndRule::Half and ThreeHalves the end segments belong whole to their only joint. With half
/// joints, and no lengths given, the joint next to an end also has what `bare_half` says.
/// @param ends    of `segment_ends`
/// @param yields  what the level bends about, if it may yield on one surface
Layout make_layout(const Scene& scene, std::vector<double> ends,
                   std::optional<law::GaugePlane> yields = {});

/// The point at a fraction of the beam's length; a node belongs to the segment before it.
SegmentPoint segment_point(const Layout& layout, double fraction);

}  // namespace plastica::chain
