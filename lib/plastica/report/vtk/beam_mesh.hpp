#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/beam_pose.hpp"
#include "plastica/report/vtk/section_faces.hpp"

namespace plastica::report {

/// The beam as a surface of quadrilaterals: the section of each segment, swept along it; not
/// installed. Walls are parted in the middle of a segment, its halves are of the joints at its
/// ends. No two segments share a point, so that the same cells serve all frames, cuts or none.
class BeamMesh {
 public:
  /// @param record  of a chain
  explicit BeamMesh(const io::SceneRecord& record);

  std::size_t points() const { return points_; }
  std::size_t cells() const { return segment_.size(); }
  /// Points of each cell, counterclockwise seen from outside (cells x 4).
  const std::vector<std::int64_t>& corners() const { return corners_; }
  const std::vector<std::int32_t>& segment() const { return segment_; }  ///< of each cell
  const std::vector<std::int32_t>& joint() const { return joint_; }      ///< of each cell

  /// All points of a pose [m] (points x 3).
  std::vector<Point3> points_of(const BeamPose& pose) const;
  /// How they move, each with its segment: v + omega x r [m/s] (points x 3).
  /// @param pose  of a result that has velocities
  std::vector<Point3> velocities_of(const BeamPose& pose) const;
  /// What a pose's fragments number each cell with, from 0 on (cells).
  std::vector<std::int32_t> fragment_of(const BeamPose& pose) const;

 private:
  void add_segment(std::size_t segment, const SectionFaces& faces);
  /// Of a segment: its rings, corner by corner, from a vector at each end and one for each axis.
  void sweep(std::size_t segment, const Point3& from, const Point3& to, const Point3& x,
             const Point3& y, std::vector<Point3>& points) const;
  void add_cell(const std::array<std::size_t, 4>& corners, std::size_t segment, std::size_t joint);

  std::vector<std::size_t> section_of_;  ///< which of the sections a segment has
  std::vector<SectionFaces> sections_;
  std::size_t points_ = 0;
  std::vector<std::int64_t> corners_;
  std::vector<std::int32_t> segment_;
  std::vector<std::int32_t> joint_;
};

}  // namespace plastica::report
