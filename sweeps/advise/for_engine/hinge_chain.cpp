#include "sweeps/advise/for_engine/hinge_chain.hpp"

#include <cmath>

#include "calibrate/engine/hinge_numbers.hpp"
#include "plastica/chain/rotation.hpp"

namespace plastica::sweeps {
namespace {

using Vector = Vec<double, 3>;
using Matrix = Mat<double, 3, 3>;

}  // namespace

HingeChain::HingeChain(const AdvisedEngine& engine, const calibrate::EngineBeam& beam,
                       const std::array<bool, 3>& turns)
    : EngineChain(beam.time_step), engine_(&engine) {
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const calibrate::EngineSegment& numbers = beam.segments[i];
    const Matrix frame = frame_of(numbers.axes);
    Segment segment;
    segment.mass = numbers.mass;
    segment.inertia = {numbers.inertia};
    segment.center = transposed_times(frame, Vector{numbers.center()} - Vector{numbers.start});
    segment.first = joints_.size();
    const Matrix before = i == 0 ? identity<double, 3>() : frame_of(beam.segments[i - 1].axes);
    const Vector from = i == 0 ? Vector{} : Vector{beam.segments[i - 1].start};
    segment.offset = transposed_times(before, Vector{numbers.start} - from);
    segment.relative = transpose(before) * frame;
    segments_.push_back(segment);
    add_joints(beam, joint_before(beam, i), turns);
    segments_.back().last = joints_.size();
  }
  check_held_at_start(beam);
  place();
}

void HingeChain::add_joints(const calibrate::EngineBeam& beam, const calibrate::EngineJoint& joint,
                            const std::array<bool, 3>& turns) {
  const Matrix frame = frame_of(beam.segments[joint.child].axes);
  for (std::size_t k = 0; k < 3; ++k) {
    if (joint.holds[k]) continue;
    Joint slide;
    slide.slides = true;
    slide.axis = transposed_times(frame, Vector{beam.scene_axes[k]});
    joints_.push_back(slide);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (joint.rotation[k] == calibrate::JointHold::Rigid || !turns[k]) continue;
    Joint hinge;
    hinge.about = k;
    hinge.axis = transposed_times(frame, Vector{joint.axes[k]});
    const calibrate::HingeNumbers numbers =
        calibrate::hinge_numbers(engine_->hinges, beam, joint, k);
    hinge.stiffness = numbers.stiffness;
    hinge.damping = numbers.damping;
    hinge.added_inertia =
        numbers.armature + (engine_->implicit_damping ? beam.time_step * numbers.damping : 0.0);
    joints_.push_back(hinge);
  }
}

void HingeChain::set_state(std::span<const double> positions, std::span<const double> speeds) {
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    joints_[j].position = positions[j];
    joints_[j].speed = speeds[j];
  }
  place();
}

void HingeChain::set_rest(std::size_t axis, double angle) {
  for (std::size_t j = segments_[0].first; j < segments_[0].last; ++j) {
    if (!joints_[j].slides && joints_[j].about == axis) joints_[j].rest = angle;
  }
}

void HingeChain::place() {
  SegmentPose at;
  for (Segment& segment : segments_) {
    segment.reach = at.frame * segment.offset;
    at.position += segment.reach;
    at.velocity += cross(at.spin, segment.reach);
    at.frame = at.frame * segment.relative;
    for (std::size_t j = segment.first; j < segment.last; ++j) {
      Joint& joint = joints_[j];
      joint.world_axis = at.frame * joint.axis;
      joint.turning = cross(at.spin, joint.world_axis);
      if (joint.slides) {
        at.position += joint.position * joint.world_axis;
        at.velocity += joint.speed * joint.world_axis;
      } else {
        at.frame = at.frame * chain::rotation_matrix(joint.position * joint.axis);
        at.spin += joint.speed * joint.world_axis;
      }
    }
    segment.pose = at;
  }
}

void HingeChain::load(const Vector& gravity, std::span<const SegmentWrench> wrenches) {
  Vector angular;
  Vector linear = -gravity;  // a ground that accelerates upward
  Vector spin;
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Segment& segment = segments_[i];
    linear += cross(angular, segment.reach) + cross(spin, cross(spin, segment.reach));
    for (std::size_t j = segment.first; j < segment.last; ++j) {
      // Slides stand on the ground, which does not turn.
      if (!joints_[j].slides) angular += joints_[j].speed * joints_[j].turning;
    }
    spin = segment.pose.spin;
    const Matrix& frame = segment.pose.frame;
    const Vector arm = frame * segment.center;
    const Matrix by = skew(arm);
    Matrix scaled = frame;
    for (std::size_t k = 0; k < 9; ++k) scaled.at[k] *= segment.inertia[k % 3];
    const Matrix inertia = scaled * transpose(frame);
    const Vector mass_force =
        segment.mass * (linear + cross(angular, arm) + cross(spin, cross(spin, arm)));
    segment.force = mass_force - wrenches[i].force;
    segment.moment = inertia * angular + cross(spin, inertia * spin) + cross(arm, mass_force) -
                     wrenches[i].moment;
    segment.aa = inertia - segment.mass * (by * by);
    segment.al = segment.mass * by;
    segment.ll = segment.mass * identity<double, 3>();
  }
}

void HingeChain::eliminate() {
  for (std::size_t i = segments_.size(); i-- > 0;) {
    Segment& s = segments_[i];
    for (std::size_t j = s.last; j-- > s.first;) {
      Joint& joint = joints_[j];
      const Vector& axis = joint.world_axis;
      joint.held_moment = joint.slides ? s.al * axis : s.aa * axis;
      joint.held_force = joint.slides ? s.ll * axis : transposed_times(s.al, axis);
      joint.inertia =
          joint.added_inertia + dot(axis, joint.slides ? joint.held_force : joint.held_moment);
      joint.drive = -joint.stiffness * (joint.position - joint.rest) - joint.damping * joint.speed -
                    dot(axis, joint.slides ? s.force : s.moment);
      const double compliance = 1.0 / joint.inertia;
      s.aa -= outer(compliance * joint.held_moment, joint.held_moment);
      s.al -= outer(compliance * joint.held_moment, joint.held_force);
      s.ll -= outer(compliance * joint.held_force, joint.held_force);
      s.moment += (compliance * joint.drive) * joint.held_moment;
      s.force += (compliance * joint.drive) * joint.held_force;
    }
    if (i == 0) break;
    Segment& before = segments_[i - 1];
    const Matrix by = skew(s.reach);
    const Matrix al = s.al + by * s.ll;
    before.ll += s.ll;
    before.al += al;
    before.aa += s.aa - s.al * by + by * transpose(al);
    before.force += s.force;
    before.moment += s.moment + cross(s.reach, s.force);
  }
}

bool HingeChain::advance() {
  bool in_range = true;
  Vector angular;
  Vector linear;
  for (const Segment& segment : segments_) {
    linear += cross(angular, segment.reach);
    for (std::size_t j = segment.first; j < segment.last; ++j) {
      Joint& joint = joints_[j];
      const double acceleration =
          (joint.drive - dot(joint.held_moment, angular) - dot(joint.held_force, linear)) /
          joint.inertia;
      (joint.slides ? linear : angular) += acceleration * joint.world_axis;
      joint.speed += time_step() * acceleration;
      joint.position += time_step() * joint.speed;
      in_range = in_range && is_in_range(acceleration) && is_in_range(joint.speed) &&
                 is_in_range(joint.position);
    }
  }
  return in_range;
}

bool HingeChain::step(const Vector& gravity, std::span<const SegmentWrench> wrenches) {
  load(gravity, wrenches);
  eliminate();
  const bool in_range = advance();
  place();
  return in_range;
}

}  // namespace plastica::sweeps
