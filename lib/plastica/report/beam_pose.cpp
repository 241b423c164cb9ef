#include "plastica/report/beam_pose.hpp"

#include <cmath>

#include "plastica/report/scene_frames.hpp"

namespace plastica::report {
namespace {

/// A vector turned by a rotation vector (Rodrigues' formula).
Point3 rotated(const Point3& rotation, const Point3& v) {
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

}  // namespace

BeamPose::BeamPose(const io::SceneRecord& record, std::size_t frame)
    : record_(&record), frame_(frame) {
  const ChainHistory& chain = record.response.chain;
  const std::size_t n = record.outline.segments();
  const bool undeformed = frame == kUndeformed;
  if (undeformed) {
    cut_.assign(n + 1, false);
    fragments_ = {{0, static_cast<int>(n) - 1}};
  } else {
    time_ = time_of_frame(record, frame);
    cut_ = cut_joints(record, time_);
    fragments_ = fragments_at(record, time_);
  }
  const auto node = [&](std::size_t i) {
    return undeformed ? three(record.outline.node, i)
                      : three(chain.position, frame * chain.joints + i);
  };
  for (std::size_t i = 0; i < n; ++i) {
    inner_.push_back(node(i));
    if (!cut_[i + 1] || i + 1 == n) {
      outer_.push_back(node(i + 1));
      continue;
    }
    const Point3 chord =
        sum(three(record.outline.node, i + 1), -1.0, three(record.outline.node, i));
    outer_.push_back(sum(inner_[i], 1.0, rotated(three(chain.rotation, frame * n + i), chord)));
  }
}

Point3 BeamPose::section_axis(std::size_t segment, std::size_t axis) const {
  const Point3 undeformed = three(record_->outline.axes, 3 * segment + axis);
  if (frame_ == kUndeformed) return undeformed;
  return rotated(three(record_->response.chain.rotation, frame_ * segments() + segment),
                 undeformed);
}

Point3 BeamPose::inner_velocity(std::size_t segment) const {
  return three(record_->response.chain.velocity, frame_ * segments() + segment);
}

Point3 BeamPose::outer_velocity(std::size_t segment) const {
  if (is_joined(segment)) return inner_velocity(segment + 1);
  const Point3 chord = sum(outer_[segment], -1.0, inner_[segment]);
  return sum(inner_velocity(segment), 1.0, cross(spin(segment), chord));
}

Point3 BeamPose::spin(std::size_t segment) const {
  return three(record_->response.chain.spin, frame_ * segments() + segment);
}

std::size_t BeamPose::segment_at(double fraction) const {
  const std::vector<double>& ends = record_->outline.ends;
  std::size_t i = 0;
  while (i + 2 < ends.size() && ends[i + 1] < fraction) ++i;
  return i;
}

Point3 BeamPose::point_at(double fraction) const {
  const std::vector<double>& ends = record_->outline.ends;
  const std::size_t i = segment_at(fraction);
  const double t = (fraction - ends[i]) / (ends[i + 1] - ends[i]);
  return sum(inner_[i], t, sum(outer_[i], -1.0, inner_[i]));
}

std::vector<Point2> BeamPose::axis_of(const Fragment& fragment, const Eye& eye) const {
  std::vector<Point2> axis;
  for (int i = fragment.first; i <= fragment.last; ++i) {
    axis.push_back(eye.at(inner_[static_cast<std::size_t>(i)]));
  }
  axis.push_back(eye.at(outer_[static_cast<std::size_t>(fragment.last)]));
  return axis;
}

std::vector<std::vector<Point2>> BeamPose::axes(const Eye& eye) const {
  std::vector<std::vector<Point2>> axes;
  for (const Fragment& fragment : fragments_) axes.push_back(axis_of(fragment, eye));
  return axes;
}

}  // namespace plastica::report
