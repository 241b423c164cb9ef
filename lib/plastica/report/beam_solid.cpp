#include "plastica/report/beam_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica::report {
namespace {

/// Segments that a picture can show; more are drawn in groups.
constexpr std::size_t kMaxSegments = 150;
constexpr std::size_t kSidesOfRound = 16;

/// Corners of a segment's section about its axis.
std::vector<Point3> section_corners(const BeamPose& pose, std::size_t segment, double thickness) {
  const BeamOutline& outline = pose.record().outline;
  const Point3 x = pose.section_axis(segment, 0);
  const Point3 y = pose.section_axis(segment, 1);
  const double half_width = 0.5 * thickness * outline.width[segment];
  const double half_height = 0.5 * thickness * outline.height[segment];
  std::vector<Point3> corners;
  const auto add = [&](double along_x, double along_y) {
    corners.push_back(sum(sum({}, along_x * half_width, x), along_y * half_height, y));
  };
  if (outline.round[segment] == 0) {
    for (const auto& [a, b] : {Point2{-1, -1}, Point2{1, -1}, Point2{1, 1}, Point2{-1, 1}}) {
      add(a, b);
    }
  } else {
    for (std::size_t k = 0; k < kSidesOfRound; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / kSidesOfRound;
      add(std::cos(angle), std::sin(angle));
    }
  }
  return corners;
}

/// What is at the outer side of half a segment: its other half, another segment, or nothing.
enum class Beyond { Segment, End, Cut };

class Drawing {
 public:
  explicit Drawing(const Eye& eye) : eye_(eye) {}

  /// One half of a segment, from the middle to an end of it.
  /// @param outer  whether it is the outer half
  void add_half(const std::vector<Point3>& corners, const Point3& middle, const Point3& end,
                std::size_t joint, bool outer, Beyond beyond) {
    const std::size_t sides = corners.size();
    const bool round = sides > 4;
    const Point3& from = outer ? middle : end;
    const Point3& to = outer ? end : middle;
    Lines& rim = beyond == Beyond::Segment ? solid_.segments
                                           : (beyond == Beyond::End ? solid_.edges : solid_.cuts);
    for (std::size_t k = 0; k < sides; ++k) {
      const Point3& a = corners[k];
      const Point3& b = corners[(k + 1) % sides];
      const std::vector<Point3> face{sum(from, 1.0, a), sum(from, 1.0, b), sum(to, 1.0, b),
                                     sum(to, 1.0, a)};
      if (!add_face(face, sum(a, 1.0, b), joint)) continue;
      // Four lines along a round section show its twist.
      if (!round || k % 4 == 0) line(solid_.edges, face[0], face[3]);
      if (!round || (k + 1) % 4 == 0) line(solid_.edges, face[1], face[2]);
      line(rim, outer ? face[3] : face[0], outer ? face[2] : face[1]);
    }
    std::vector<Point3> cap;
    for (const Point3& corner : corners) cap.push_back(sum(end, 1.0, corner));
    const bool seen = add_face(cap, sum(end, -1.0, middle), joint);
    if (seen && beyond != Beyond::Segment) {
      for (std::size_t k = 0; k < sides; ++k) line(rim, cap[k], cap[(k + 1) % sides]);
    }
  }

  BeamSolid finish() {
    std::stable_sort(solid_.faces.begin(), solid_.faces.end(),
                     [](const Face& a, const Face& b) { return a.depth > b.depth; });
    return std::move(solid_);
  }

 private:
  /// @return whether it faces the viewer
  bool add_face(const std::vector<Point3>& corners, const Point3& outwards, std::size_t joint) {
    const double size = std::sqrt(dot(outwards, outwards));
    const double facing = size > 0.0 ? -dot(outwards, eye_.away) / size : 0.0;
    if (facing <= 1e-9) return false;
    Face face;
    Point3 middle{};
    for (const Point3& corner : corners) {
      face.corners.push_back(eye_.at(corner));
      middle = sum(middle, 1.0 / static_cast<double>(corners.size()), corner);
    }
    face.depth = eye_.depth(middle);
    const double from_above = size > 0.0 ? dot(outwards, eye_.up) / size : 0.0;
    face.light = std::clamp(0.82 + 0.18 * from_above, 0.7, 1.0);
    face.joint = joint;
    solid_.faces.push_back(std::move(face));
    return true;
  }

  void line(Lines& lines, const Point3& a, const Point3& b) const {
    lines.push_back({eye_.at(a), eye_.at(b)});
  }

  const Eye& eye_;
  BeamSolid solid_;
};

}  // namespace

BeamSolid beam_solid(const BeamPose& pose, const Eye& eye, double thickness) {
  const std::size_t segments = pose.segments();
  const std::size_t step = (segments + kMaxSegments - 1) / kMaxSegments;
  Drawing drawing(eye);
  for (const Fragment& fragment : pose.fragments()) {
    const auto first = static_cast<std::size_t>(fragment.first);
    const std::size_t behind = static_cast<std::size_t>(fragment.last) + 1;
    const auto beyond = [&](std::size_t joint) {
      if (joint != first && joint != behind) return Beyond::Segment;
      return joint == 0 || joint == segments ? Beyond::End : Beyond::Cut;
    };
    for (std::size_t i = first; i < behind; i += step) {
      const std::size_t end = std::min(i + step, behind);
      const Point3& from = pose.inner(i);
      const Point3& to = pose.outer(end - 1);
      const Point3 middle = sum(sum({}, 0.5, from), 0.5, to);
      const std::vector<Point3> corners = section_corners(pose, (i + end - 1) / 2, thickness);
      drawing.add_half(corners, middle, from, i, false, beyond(i));
      drawing.add_half(corners, middle, to, end, true, beyond(end));
    }
  }
  return drawing.finish();
}

}  // namespace plastica::report
