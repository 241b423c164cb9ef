#include "plastica/report/beam_solid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica::report {
namespace {

/// Segments that a picture can show; more are drawn in groups.
constexpr std::size_t kMostSegments = 150;
constexpr std::size_t kSidesOfRound = 16;

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point3 cross(const Point3& a, const Point3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point3 sum(const Point3& a, double factor, const Point3& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

/// A vector turned by a rotation vector (Rodrigues' formula).
Point3 turned(const Point3& rotation, const Point3& v) {
  const double angle = std::sqrt(dot(rotation, rotation));
  if (angle == 0.0) return v;
  const Point3 axis{rotation[0] / angle, rotation[1] / angle, rotation[2] / angle};
  Point3 result{};
  result = sum(result, std::cos(angle), v);
  result = sum(result, std::sin(angle), cross(axis, v));
  return sum(result, (1.0 - std::cos(angle)) * dot(axis, v), axis);
}

Point3 three(const std::vector<double>& values, std::size_t index) {
  return {values[3 * index], values[3 * index + 1], values[3 * index + 2]};
}

/// Axis x or y of a segment's section in world axes.
Point3 section_axis(const io::SceneRecord& record, std::size_t sample, std::size_t segment,
                    std::size_t axis) {
  const Point3 undeformed = three(record.outline.axes, 3 * segment + axis);
  if (sample == kUndeformed) return undeformed;
  const std::size_t segments = record.outline.segments();
  return turned(three(record.response.chain.rotation, sample * segments + segment), undeformed);
}

/// Corners of a segment's section about its axis.
std::vector<Point3> section_corners(const io::SceneRecord& record, std::size_t sample,
                                    std::size_t segment, double thickness) {
  const Point3 x = section_axis(record, sample, segment, 0);
  const Point3 y = section_axis(record, sample, segment, 1);
  const double half_width = 0.5 * thickness * record.outline.width[segment];
  const double half_height = 0.5 * thickness * record.outline.height[segment];
  std::vector<Point3> corners;
  const auto add = [&](double along_x, double along_y) {
    corners.push_back(sum(sum({}, along_x * half_width, x), along_y * half_height, y));
  };
  if (record.outline.round[segment] == 0) {
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

class Drawing {
 public:
  Drawing(const io::SceneRecord& record, const Eye& eye) : record_(record), eye_(eye) {}

  /// One half of a segment, from one point of the axis to another.
  /// @param at_end  whether the beam ends here, so that its end face is drawn with its edges
  void add_half(const std::vector<Point3>& corners, const Point3& from, const Point3& to,
                std::size_t joint, bool outer, bool at_end) {
    const std::size_t sides = corners.size();
    const bool round = sides > 4;
    for (std::size_t k = 0; k < sides; ++k) {
      const Point3& a = corners[k];
      const Point3& b = corners[(k + 1) % sides];
      const std::vector<Point3> face{sum(from, 1.0, a), sum(from, 1.0, b), sum(to, 1.0, b),
                                     sum(to, 1.0, a)};
      const Point3 outwards = sum(a, 1.0, b);
      if (!add_face(face, outwards, joint)) continue;
      // Four lines along a round section show its twist.
      if (!round || k % 4 == 0) edge(face[0], face[3]);
      if (!round) edge(face[1], face[2]);
      edge(outer ? face[3] : face[0], outer ? face[2] : face[1]);
    }
    std::vector<Point3> end;
    const Point3& at = outer ? to : from;
    for (const Point3& corner : corners) end.push_back(sum(at, 1.0, corner));
    const bool seen = add_face(end, outer ? sum(to, -1.0, from) : sum(from, -1.0, to), joint);
    if (seen && at_end) {
      for (std::size_t k = 0; k < sides; ++k) edge(end[k], end[(k + 1) % sides]);
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

  void edge(const Point3& a, const Point3& b) { solid_.edges.push_back({eye_.at(a), eye_.at(b)}); }

  const io::SceneRecord& record_;
  const Eye& eye_;
  BeamSolid solid_;
};

}  // namespace

Point2 Eye::at(const Point3& point) const { return {dot(right, point), dot(up, point)}; }
double Eye::depth(const Point3& point) const { return dot(away, point); }

Point3 node_at(const io::SceneRecord& record, std::size_t sample, std::size_t node) {
  if (sample == kUndeformed) return three(record.outline.node, node);
  return three(record.response.chain.position, sample * record.response.chain.joints + node);
}

std::vector<Point2> axis_of(const io::SceneRecord& record, std::size_t sample, const Eye& eye) {
  std::vector<Point2> axis;
  for (std::size_t i = 0; i <= record.outline.segments(); ++i) {
    axis.push_back(eye.at(node_at(record, sample, i)));
  }
  return axis;
}

BeamSolid beam_solid(const io::SceneRecord& record, std::size_t sample, const Eye& eye,
                     double thickness) {
  const std::size_t segments = record.outline.segments();
  const std::size_t step = (segments + kMostSegments - 1) / kMostSegments;
  Drawing drawing(record, eye);
  for (std::size_t i = 0; i < segments; i += step) {
    const std::size_t end = std::min(i + step, segments);
    const Point3 from = node_at(record, sample, i);
    const Point3 to = node_at(record, sample, end);
    const Point3 middle = sum(sum({}, 0.5, from), 0.5, to);
    const std::vector<Point3> corners =
        section_corners(record, sample, (i + end - 1) / 2, thickness);
    drawing.add_half(corners, from, middle, i, false, i == 0);
    drawing.add_half(corners, middle, to, end, true, end == segments);
  }
  return drawing.finish();
}

}  // namespace plastica::report
