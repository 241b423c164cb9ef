#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "plastica/io/scene_store.hpp"

/// Where the segments of a beam are; not installed.
namespace plastica::report {

using Point3 = std::array<double, 3>;
using Point2 = std::array<double, 2>;

inline double dot(const Point3& a, const Point3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3 sum(const Point3& a, double factor, const Point3& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

inline Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A direction to look along: how points in world axes fall on the picture.
struct Eye {
  Point3 right{};  ///< unit vectors in world axes
  Point3 up{};
  Point3 away{};  ///< from the viewer
  Point2 at(const Point3& point) const { return {dot(right, point), dot(up, point)}; }
  double depth(const Point3& point) const { return dot(away, point); }
};

/// The undeformed beam instead of a frame.
inline constexpr std::size_t kUndeformed = static_cast<std::size_t>(-1);

/// The beam in one frame, in world axes. Segments that a cut parts have ends of their own: the
/// outer one is where the segment's rotation takes it.
class BeamPose {
 public:
  BeamPose(const io::SceneRecord& record, std::size_t frame);

  const io::SceneRecord& record() const { return *record_; }
  std::size_t frame() const { return frame_; }
  double time() const { return time_; }  ///< [s]; of the undeformed beam 0
  std::size_t segments() const { return outer_.size(); }
  const Point3& inner(std::size_t segment) const { return inner_[segment]; }
  const Point3& outer(std::size_t segment) const { return outer_[segment]; }
  bool is_cut(std::size_t joint) const { return cut_[joint]; }
  const std::vector<Fragment>& fragments() const { return fragments_; }

  /// Axis x, y or z of a segment's section, a unit vector.
  Point3 section_axis(std::size_t segment, std::size_t axis) const;
  // How the same points move, of a frame of a result that has velocities, in world axes:
  Point3 inner_velocity(std::size_t segment) const;  ///< [m/s]
  Point3 outer_velocity(std::size_t segment) const;  ///< of the joint there, unless it is cut [m/s]
  Point3 spin(std::size_t segment) const;            ///< [rad/s]
  /// The point of the axis at a fraction of the length; at a cut that of the segment before it.
  Point3 point_at(double fraction) const;
  /// Number of the segment that `point_at` is on.
  std::size_t segment_at(double fraction) const;
  /// The axis of a fragment as points on the picture.
  std::vector<Point2> axis_of(const Fragment& fragment, const Eye& eye) const;
  /// The axes of all fragments.
  std::vector<std::vector<Point2>> axes(const Eye& eye) const;

 private:
  /// Whether a segment ends in the joint that the next one begins with.
  bool is_joined(std::size_t segment) const {
    return segment + 1 < segments() && !cut_[segment + 1];
  }

  const io::SceneRecord* record_;
  std::size_t frame_;
  double time_ = 0.0;
  std::vector<bool> cut_;
  std::vector<Fragment> fragments_;
  std::vector<Point3> inner_;
  std::vector<Point3> outer_;
};

}  // namespace plastica::report
