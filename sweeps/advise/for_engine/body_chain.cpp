#include "sweeps/advise/for_engine/body_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/engine/hinge_numbers.hpp"
#include "plastica/chain/rotation.hpp"

namespace plastica::sweeps {
namespace {

using Vector = Vec<double, 3>;
using Matrix = Mat<double, 3, 3>;

/// What Chrono clamps C/h at: its `max_penetration_recovery_speed`, as it is by default.
constexpr double kRecoverySpeed = 0.6;

/// Rows of a body and of its impulses; behind 12 columns of these the right-hand sides.
constexpr std::size_t kSides = 7;
using Rows = Mat<double, 12, 12 + kSides>;

/// Solves the first n rows by their first n columns, with pivots; the sides become the solution.
void solve_rows(Rows& a, std::size_t n) {
  constexpr std::size_t kEnd = 12 + kSides;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::abs(a(i, k)) > std::abs(a(pivot, k))) pivot = i;
    }
    for (std::size_t j = k; pivot != k && j < kEnd; ++j) std::swap(a(pivot, j), a(k, j));
    const double inverse = 1.0 / a(k, k);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = inverse * a(i, k);
      if (factor == 0.0) continue;
      for (std::size_t j = k + 1; j < n; ++j) a(i, j) -= factor * a(k, j);
      for (std::size_t j = 12; j < kEnd; ++j) a(i, j) -= factor * a(k, j);
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    const double inverse = 1.0 / a(k, k);
    for (std::size_t j = 12; j < kEnd; ++j) a(k, j) *= inverse;
    for (std::size_t i = 0; i < k; ++i) {
      const double factor = a(i, k);
      if (factor == 0.0) continue;
      for (std::size_t j = 12; j < kEnd; ++j) a(i, j) -= factor * a(k, j);
    }
  }
}

/// h D + h^2 K.
Matrix in_step(double h, const Matrix& damping, const Matrix& stiffness) {
  return h * damping + (h * h) * stiffness;
}

/// One step of Newton's method to the nearest rotation: rounding does not add up.
Matrix kept_orthogonal(const Matrix& frame) {
  return 0.5 * (frame * (3.0 * identity<double, 3>() - transpose(frame) * frame));
}

Vector part(const Vec<double, 6>& v, std::size_t from) {
  return {{v[from], v[from + 1], v[from + 2]}};
}

}  // namespace

BodyChain::BodyChain(const AdvisedEngine& engine, const calibrate::EngineBeam& beam)
    : EngineChain(beam.time_step), engine_(&engine) {
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const calibrate::EngineSegment& segment = beam.segments[i];
    const calibrate::EngineJoint& numbers = joint_before(beam, i);
    Body body;
    body.mass = segment.mass;
    body.inertia = {segment.inertia};
    body.state.position = {segment.center()};
    body.state.frame = frame_of(segment.axes);
    body.center = transposed_times(body.state.frame, body.state.position - Vector{segment.start});
    const Matrix axes = frame_of(numbers.axes);
    const Vector point{numbers.point};
    const BodyState& held_on = before(i);
    body.joint.axes_here = transpose(body.state.frame) * axes;
    body.joint.axes_before = transpose(held_on.frame) * axes;
    body.joint.point_here = transposed_times(body.state.frame, point - body.state.position);
    body.joint.point_before = transposed_times(held_on.frame, point - held_on.position);
    body.joint.holds_translation = numbers.holds;
    for (std::size_t k = 0; k < 3; ++k) {
      body.joint.holds_rotation[k] = numbers.rotation[k] == calibrate::JointHold::Rigid;
      const auto bushing = calibrate::hinge_numbers(engine.hinges, beam, numbers, k);
      body.joint.stiffness[k] = bushing.stiffness;
      body.joint.damping[k] = bushing.damping;
    }
    if (i == 0) {
      first_axes_ = axes;
      first_point_ = point;
    }
    bodies_.push_back(body);
    place(bodies_.back());
  }
  check_held_at_start(beam);
}

void BodyChain::set_rest(std::size_t axis, double angle) {
  if (turned_[axis] == angle) return;
  turned_[axis] = angle;
  ground_.frame = first_axes_ * chain::rotation_matrix(turned_) * transpose(first_axes_);
  ground_.position = first_point_ - ground_.frame * first_point_;
}

void BodyChain::set_motion(std::size_t segment, const Vector& velocity, const Vector& spin) {
  Body& body = bodies_[segment];
  body.state.spin = transposed_times(body.state.frame, spin);
  body.state.velocity = velocity + cross(spin, body.state.frame * body.center);
  place(body);
}

void BodyChain::place(Body& body) const {
  const Vector arm = body.state.frame * body.center;
  body.pose.frame = body.state.frame;
  body.pose.position = body.state.position - arm;
  body.pose.spin = body.state.frame * body.state.spin;
  body.pose.velocity = body.state.velocity - cross(body.pose.spin, arm);
}

void BodyChain::load(const Vector& gravity, std::span<const SegmentWrench> wrenches) {
  const double h = time_step();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    const Matrix& frame = body.state.frame;
    const Vector force = body.mass * gravity + wrenches[i].force;
    const Vector moment = wrenches[i].moment - cross(frame * body.center, wrenches[i].force);
    Vector momentum;
    for (std::size_t k = 0; k < 3; ++k) momentum[k] = body.inertia[k] * body.state.spin[k];
    const Vector turning = transposed_times(frame, moment) - cross(body.state.spin, momentum);
    body.matrix = {};
    for (std::size_t k = 0; k < 3; ++k) {
      body.matrix(k, k) = body.mass;
      body.matrix(3 + k, 3 + k) = body.inertia[k];
      body.drive[k] = body.mass * body.state.velocity[k] + h * force[k];
      body.drive[3 + k] = momentum[k] + h * turning[k];
    }
  }
}

void BodyChain::add_joints() {
  const double h = time_step();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    body.mate = mate_terms(body.joint, body.state, before(i));
    const BushingTerms bushing = bushing_terms(body.joint, body.state, before(i));
    for (std::size_t k = 0; k < 3; ++k) body.drive[3 + k] += h * bushing.moment_here[k];
    add(body.matrix, 3, 3, in_step(h, bushing.damping_here_here, bushing.stiffness_here_here));
    if (i == 0) continue;
    Body& held_on = bodies_[i - 1];
    for (std::size_t k = 0; k < 3; ++k) held_on.drive[3 + k] += h * bushing.moment_before[k];
    add(held_on.matrix, 3, 3,
        in_step(h, bushing.damping_before_before, bushing.stiffness_before_before));
    put(body.by_before, 3, 3,
        in_step(h, bushing.damping_here_before, bushing.stiffness_here_before));
    put(body.in_before, 3, 3,
        in_step(h, bushing.damping_before_here, bushing.stiffness_before_here));
  }
}

void BodyChain::eliminate() {
  for (std::size_t i = bodies_.size(); i-- > 0;) {
    Body& body = bodies_[i];
    const MateTerms& mate = body.mate;
    Rows rows;
    for (std::size_t r = 0; r < 6; ++r) {
      for (std::size_t c = 0; c < 6; ++c) {
        rows(r, c) = body.matrix(r, c);
        rows(r, 12 + c) = body.by_before(r, c);
      }
      rows(r, 18) = body.drive[r];
    }
    for (std::size_t m = 0; m < mate.rows; ++m) {
      for (std::size_t c = 0; c < 6; ++c) {
        rows(6 + m, c) = mate.here(m, c);
        rows(c, 6 + m) = mate.here(m, c);
        rows(6 + m, 12 + c) = mate.before(m, c);
      }
      rows(6 + m, 18) = -std::clamp(mate.gap[m] / time_step(), -kRecoverySpeed, kRecoverySpeed);
    }
    solve_rows(rows, 6 + mate.rows);
    body.solved = block<12, kSides>(rows, 0, 12);
    if (i == 0) break;
    Body& held_on = bodies_[i - 1];
    for (std::size_t r = 0; r < 6; ++r) {
      const auto taken = [&](std::size_t side) {
        double sum = 0.0;
        for (std::size_t c = 0; c < 6; ++c) sum += body.in_before(r, c) * body.solved(c, side);
        for (std::size_t m = 0; m < mate.rows; ++m) {
          sum += mate.before(m, r) * body.solved(6 + m, side);
        }
        return sum;
      };
      for (std::size_t c = 0; c < 6; ++c) held_on.matrix(r, c) -= taken(c);
      held_on.drive[r] -= taken(6);
    }
  }
}

bool BodyChain::advance() {
  const double h = time_step();
  bool in_range = true;
  Vec<double, 6> velocity_before;  // the ground's: none
  for (Body& body : bodies_) {
    Vec<double, 6> velocity;
    for (std::size_t r = 0; r < 6; ++r) {
      velocity[r] = body.solved(r, 6);
      for (std::size_t c = 0; c < 6; ++c) velocity[r] -= body.solved(r, c) * velocity_before[c];
      in_range = in_range && is_in_range(velocity[r]);
    }
    if (!in_range) return false;
    BodyState& state = body.state;
    state.velocity = part(velocity, 0);
    state.spin = part(velocity, 3);
    state.position += h * state.velocity;
    state.frame = kept_orthogonal(state.frame * chain::rotation_matrix(h * state.spin));
    velocity_before = velocity;
    place(body);
  }
  return true;
}

bool BodyChain::step(const Vector& gravity, std::span<const SegmentWrench> wrenches) {
  load(gravity, wrenches);
  add_joints();
  eliminate();
  return advance();
}

}  // namespace plastica::sweeps
