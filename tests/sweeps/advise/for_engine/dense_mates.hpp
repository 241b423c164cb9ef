#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "calibrate/engine/engine_beam.hpp"
#include "sweeps/advise/for_engine/body_chain.hpp"

/// A step of Chrono's rule once more, otherwise: all bodies in one dense matrix, which is solved
/// with full pivoting; slopes of constraints and bushings by differences of the functions
/// themselves.
namespace plastica::testing {

struct DenseBody {
  double mass = 0.0;
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< from the inner end, in the body's axes
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();  ///< its own axes
};

struct DenseJoint {
  DenseBody undeformed_here, undeformed_before;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
  std::array<bool, 6> holds{};
  Eigen::Vector3d stiffness = Eigen::Vector3d::Zero();
  Eigen::Vector3d damping = Eigen::Vector3d::Zero();
};

class DenseMates {
 public:
  /// @param damping_fraction  of the beam's damping that the bushings have
  DenseMates(const calibrate::EngineBeam& beam, double damping_fraction)
      : h_(beam.time_step), bodies_(beam.segments.size()), joints_(beam.segments.size()) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const calibrate::EngineSegment& segment = beam.segments[i];
      DenseBody& body = bodies_[i];
      body.mass = segment.mass;
      body.inertia = vector(segment.inertia);
      body.position = vector(segment.center());
      body.turn = turn(segment.axes);
      body.center = body.turn.inverse() * (body.position - vector(segment.start));
      for (const calibrate::EngineJoint& numbers : beam.joints) {
        if (numbers.child != i) continue;
        DenseJoint& joint = joints_[i];
        joint.undeformed_here = body;
        if (i > 0) joint.undeformed_before = bodies_[i - 1];
        joint.point = vector(numbers.point);
        joint.axes = turn(numbers.axes);
        for (std::size_t k = 0; k < 3; ++k) {
          joint.holds[k] = numbers.holds[k];
          joint.holds[3 + k] = numbers.rotation[k] == calibrate::JointHold::Rigid;
        }
        joint.stiffness = vector(numbers.stiffness);
        joint.damping =
            damping_fraction * beam.damping_time.value_or(0.0) * vector(numbers.stiffness);
      }
    }
  }

  /// The state of a chain of ours.
  void take(const sweeps::EngineChain& chain) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const sweeps::SegmentPose& pose = chain.pose(i);
      Eigen::Matrix3d frame;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          frame(r, c) = pose.frame(static_cast<std::size_t>(r), static_cast<std::size_t>(c));
        }
      }
      DenseBody& body = bodies_[i];
      body.turn = Eigen::Quaterniond(frame).normalized();
      const Eigen::Vector3d arm = frame * body.center;
      const Eigen::Vector3d spin = vector(pose.spin.at);
      body.position = vector(pose.position.at) + arm;
      body.velocity = vector(pose.velocity.at) + spin.cross(arm);
      body.spin = frame.transpose() * spin;
    }
  }

  /// One step of all bodies.
  /// @param forces, moments  about the centers, world axes
  void step(const Eigen::Vector3d& gravity, const std::vector<Eigen::Vector3d>& forces,
            const std::vector<Eigen::Vector3d>& moments) {
    const auto n = static_cast<Eigen::Index>(6 * bodies_.size());
    std::vector<Eigen::VectorXd> rows;
    std::vector<double> right;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd drive = Eigen::VectorXd::Zero(n);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const DenseBody& body = bodies_[i];
      const auto at = static_cast<Eigen::Index>(6 * i);
      const Eigen::Vector3d momentum = body.inertia.cwiseProduct(body.spin);
      matrix.diagonal().segment<3>(at).setConstant(body.mass);
      matrix.diagonal().segment<3>(at + 3) = body.inertia;
      drive.segment<3>(at) = body.mass * body.velocity + h_ * (body.mass * gravity + forces[i]);
      drive.segment<3>(at + 3) =
          momentum + h_ * (body.turn.inverse() * moments[i] - body.spin.cross(momentum));
    }
    largest_recovery_ = 0.0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) add_joint(i, matrix, drive, rows, right);
    const auto m = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd sides = Eigen::VectorXd::Zero(n + m);
    all.topLeftCorner(n, n) = matrix;
    sides.head(n) = drive;
    for (Eigen::Index r = 0; r < m; ++r) {
      all.row(n + r).head(n) = rows[static_cast<std::size_t>(r)].transpose();
      all.col(n + r).head(n) = rows[static_cast<std::size_t>(r)];
      sides[n + r] = right[static_cast<std::size_t>(r)];
    }
    const Eigen::VectorXd solved = all.fullPivLu().solve(sides);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      DenseBody& body = bodies_[i];
      body.velocity = solved.segment<3>(static_cast<Eigen::Index>(6 * i));
      body.spin = solved.segment<3>(static_cast<Eigen::Index>(6 * i + 3));
      body.position += h_ * body.velocity;
      body.turn = body.turn * rotation(h_ * body.spin);
    }
  }

  const DenseBody& body(std::size_t i) const { return bodies_[i]; }
  /// The largest C/h of the last step.
  double largest_recovery() const { return largest_recovery_; }

  static Eigen::Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

 private:
  static Eigen::Quaterniond turn(const calibrate::EngineAxes& axes) {
    Eigen::Matrix3d frame;
    for (int k = 0; k < 3; ++k) frame.col(k) = vector(axes[static_cast<std::size_t>(k)]);
    return Eigen::Quaterniond(frame);
  }
  static Eigen::Quaterniond rotation(const Eigen::Vector3d& v) {
    const double angle = v.norm();
    if (angle == 0.0) return Eigen::Quaterniond::Identity();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, v / angle));
  }

  /// The joint's place and axes as fixed to a body.
  static Eigen::Vector3d place(const DenseJoint& joint, const DenseBody& undeformed,
                               const DenseBody& now) {
    return now.position +
           now.turn * (undeformed.turn.inverse() * (joint.point - undeformed.position));
  }
  static Eigen::Quaterniond axes(const DenseJoint& joint, const DenseBody& undeformed,
                                 const DenseBody& now) {
    return now.turn * undeformed.turn.inverse() * joint.axes;
  }

  /// What a mate closes: place, then the vector part of the quaternion, on the body before.
  static Eigen::VectorXd gaps(const DenseJoint& joint, const DenseBody& here,
                              const DenseBody& before) {
    const Eigen::Quaterniond on_before = axes(joint, joint.undeformed_before, before);
    Eigen::VectorXd gap(6);
    gap.head<3>() = on_before.inverse() * (place(joint, joint.undeformed_here, here) -
                                           place(joint, joint.undeformed_before, before));
    Eigen::Quaterniond q = on_before.inverse() * axes(joint, joint.undeformed_here, here);
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    gap.tail<3>() = q.vec();
    return gap;
  }

  /// Moments of a bushing on the body, and on the one before, each in its own axes.
  static Eigen::VectorXd moments_of(const DenseJoint& joint, const DenseBody& here,
                                    const DenseBody& before) {
    const Eigen::Quaterniond on_before = axes(joint, joint.undeformed_before, before);
    const Eigen::AngleAxisd turned(on_before.inverse() * axes(joint, joint.undeformed_here, here));
    const Eigen::Vector3d spin =
        on_before.inverse() * (here.turn * here.spin - before.turn * before.spin);
    const Eigen::Vector3d moment =
        on_before * (joint.stiffness.cwiseProduct(turned.angle() * turned.axis()) +
                     joint.damping.cwiseProduct(spin));
    Eigen::VectorXd both(6);
    both.head<3>() = -(here.turn.inverse() * moment);
    both.tail<3>() = before.turn.inverse() * moment;
    return both;
  }

  /// A state of two bodies that is moved by one of its 12 coordinates, or its velocities.
  static std::array<DenseBody, 2> moved(const std::array<DenseBody, 2>& bodies, int coordinate,
                                        double by, bool velocity) {
    std::array<DenseBody, 2> there = bodies;
    DenseBody& body = there[static_cast<std::size_t>(coordinate / 6)];
    const int k = coordinate % 6;
    if (velocity) {
      (k < 3 ? body.velocity : body.spin)[k % 3] += by;
    } else if (k < 3) {
      body.position[k] += by;
    } else {
      body.turn = body.turn * rotation(by * Eigen::Vector3d::Unit(k - 3));
    }
    return there;
  }

  /// d function/d coordinate, by differences of fourth order.
  template <typename Function>
  static Eigen::VectorXd slope(const Function& function, const std::array<DenseBody, 2>& bodies,
                               int coordinate, bool velocity) {
    constexpr double kBy = 1e-3;
    const auto at = [&](double by) -> Eigen::VectorXd {
      const auto there = moved(bodies, coordinate, by, velocity);
      return function(there[0], there[1]);
    };
    return (8.0 * (at(kBy) - at(-kBy)) - (at(2.0 * kBy) - at(-2.0 * kBy))) / (12.0 * kBy);
  }

  void add_joint(std::size_t i, Eigen::MatrixXd& matrix, Eigen::VectorXd& drive,
                 std::vector<Eigen::VectorXd>& rows, std::vector<double>& right) {
    const DenseJoint& joint = joints_[i];
    const std::array<DenseBody, 2> bodies{bodies_[i], i > 0 ? bodies_[i - 1] : DenseBody{}};
    // Where the spins and velocities of both are among all; the ground has none.
    const auto first = [&](int which) { return static_cast<Eigen::Index>(6 * i) - 6 * which; };
    const int movable = i > 0 ? 12 : 6;
    const auto moment = [&](const DenseBody& here, const DenseBody& before) {
      return moments_of(joint, here, before);
    };
    const auto gap = [&](const DenseBody& here, const DenseBody& before) {
      return gaps(joint, here, before);
    };
    const Eigen::VectorXd now = moment(bodies[0], bodies[1]);
    drive.segment<3>(first(0) + 3) += h_ * now.head<3>();
    if (i > 0) drive.segment<3>(first(1) + 3) += h_ * now.tail<3>();
    Eigen::MatrixXd jacobian(6, movable);
    for (int c = 0; c < movable; ++c) {
      const Eigen::VectorXd by =
          -(h_ * slope(moment, bodies, c, true) + h_ * h_ * slope(moment, bodies, c, false));
      const Eigen::Index column = first(c / 6) + c % 6;
      matrix.block<3, 1>(first(0) + 3, column) += by.head<3>();
      if (i > 0) matrix.block<3, 1>(first(1) + 3, column) += by.tail<3>();
      jacobian.col(c) = slope(gap, bodies, c, false);
    }
    const Eigen::VectorXd apart = gap(bodies[0], bodies[1]);
    for (int k = 0; k < 6; ++k) {
      if (!joint.holds[static_cast<std::size_t>(k)]) continue;
      Eigen::VectorXd row = Eigen::VectorXd::Zero(matrix.cols());
      for (int c = 0; c < movable; ++c) row[first(c / 6) + c % 6] = jacobian(k, c);
      rows.push_back(row);
      right.push_back(-std::clamp(apart[k] / h_, -0.6, 0.6));
      largest_recovery_ = std::max(largest_recovery_, std::abs(apart[k] / h_));
    }
  }

  double h_ = 0.0;
  std::vector<DenseBody> bodies_;
  std::vector<DenseJoint> joints_;
  double largest_recovery_ = 0.0;
};

}  // namespace plastica::testing
