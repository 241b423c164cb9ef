#pragma once

#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/chain/rotation.hpp"

/// The algebra of rigid motion at each level of modelling: what differs between a twisted, a
/// planar and a spatial chain. All that follows (kinematics, recursion, solver) is written once.
///
/// A pose is a point and a frame. Small motions of a segment are (translation of its inner joint,
/// spin), wrenches (force, moment about the inner joint); both in world axes.
/// Each level has: kTranslations, kRotations, Point, Spin, Frame, and
///   turn(frame, local), turn_back(frame, world)   a vector to and from world axes;
///   then(frame, local)                            the frame `local` seen from `frame`;
///   then_back(frame, local)                       frame times the inverse of `local`;
///   rotation(theta)                               the frame turned by a rotation vector;
///   angle_from(frame, other)                      the rotation vector from one to the other, in
///                                                 the first's axes;
///   spun(spin, arm)                               velocity of the end of an arm;
///   moment(arm, force)                            arm x force;
///   axes(frame)                                   spins in the frame's axes to world axes;
///   turn_matrix(frame)                            the matrix of `turn`;
///   spun_by(arm)          d(arm) / d(spin), the arm being fixed to a segment;
///   moment_by(arm, force) d(arm x force) / d(spin) at constant force;
///   turned_by(moment)     d(moment) / d(spin), the moment being fixed to the segment;
///   turn_by(spin, theta)  the rotation vector after a small spin.
namespace plastica::chain {

/// Rotation about the beam's axis alone: no translation, one angle.
template <class S>
struct Twist {
  using Scalar = S;
  static constexpr std::size_t kTranslations = 0;
  static constexpr std::size_t kRotations = 1;
  using Point = Vec<S, 0>;
  using Spin = Vec<S, 1>;
  struct Frame {
    S angle{};
  };

  static Point turn(const Frame& /*frame*/, const Point& local) { return local; }
  static Point turn_back(const Frame& /*frame*/, const Point& world) { return world; }
  static Frame then(const Frame& frame, const Frame& local) { return {frame.angle + local.angle}; }
  static Frame then_back(const Frame& frame, const Frame& local) {
    return {frame.angle - local.angle};
  }
  static Frame rotation(const Spin& theta) { return {theta[0]}; }
  static Spin angle_from(const Frame& f, const Frame& g) { return {{g.angle - f.angle}}; }
  static Point spun(const Spin& /*spin*/, const Point& arm) { return arm; }
  static Spin moment(const Point& /*arm*/, const Point& /*force*/) { return {}; }
  static Mat<S, 1, 1> axes(const Frame& /*frame*/) { return identity<S, 1>(); }
  static Mat<S, 0, 1> spun_by(const Point& /*arm*/) { return {}; }
  static Mat<S, 1, 1> moment_by(const Point& /*arm*/, const Point& /*force*/) { return {}; }
  static Mat<S, 1, 1> turned_by(const Spin& /*moment*/) { return {}; }
  static Spin turn_by(const Spin& spin, const Spin& theta) { return theta + spin; }
};

/// Motion in a plane with the axes (along the undeformed beam, across); angles from the first to
/// the second.
template <class S>
struct Planar {
  using Scalar = S;
  static constexpr std::size_t kTranslations = 2;
  static constexpr std::size_t kRotations = 1;
  using Point = Vec<S, 2>;
  using Spin = Vec<S, 1>;
  /// The angle is kept beside its cosine and sine, so that turns are counted.
  struct Frame {
    S angle{};
    S cosine = constant<S>(1);
    S sine{};
  };

  static Point turn(const Frame& f, const Point& p) {
    return {{f.cosine * p[0] - f.sine * p[1], f.sine * p[0] + f.cosine * p[1]}};
  }
  static Point turn_back(const Frame& f, const Point& p) {
    return {{f.cosine * p[0] + f.sine * p[1], f.cosine * p[1] - f.sine * p[0]}};
  }
  static Frame then(const Frame& f, const Frame& g) {
    return {f.angle + g.angle, f.cosine * g.cosine - f.sine * g.sine,
            f.sine * g.cosine + f.cosine * g.sine};
  }
  static Frame then_back(const Frame& f, const Frame& g) {
    return {f.angle - g.angle, f.cosine * g.cosine + f.sine * g.sine,
            f.sine * g.cosine - f.cosine * g.sine};
  }
  static Frame rotation(const Spin& theta) { return {theta[0], cos(theta[0]), sin(theta[0])}; }
  static Spin angle_from(const Frame& f, const Frame& g) { return {{g.angle - f.angle}}; }
  static Point spun(const Spin& w, const Point& arm) { return {{-(w[0] * arm[1]), w[0] * arm[0]}}; }
  static Spin moment(const Point& arm, const Point& force) {
    return {{arm[0] * force[1] - arm[1] * force[0]}};
  }
  static Mat<S, 1, 1> axes(const Frame& /*f*/) { return identity<S, 1>(); }
  static Mat<S, 2, 2> turn_matrix(const Frame& f) {
    return {{f.cosine, -f.sine, f.sine, f.cosine}};
  }
  static Mat<S, 2, 1> spun_by(const Point& arm) { return {{-arm[1], arm[0]}}; }
  static Mat<S, 1, 1> moment_by(const Point& arm, const Point& force) {
    return {{-dot(arm, force)}};
  }
  static Mat<S, 1, 1> turned_by(const Spin& /*moment*/) { return {}; }
  static Spin turn_by(const Spin& spin, const Spin& theta) { return theta + spin; }
};

/// Motion in space.
template <class S>
struct Spatial {
  using Scalar = S;
  static constexpr std::size_t kTranslations = 3;
  static constexpr std::size_t kRotations = 3;
  using Point = Vec<S, 3>;
  using Spin = Vec<S, 3>;
  struct Frame {
    Mat<S, 3, 3> axes = identity<S, 3>();  ///< columns: the frame's axes in world axes
  };

  static Point turn(const Frame& f, const Point& p) { return f.axes * p; }
  static Point turn_back(const Frame& f, const Point& p) { return transposed_times(f.axes, p); }
  static Frame then(const Frame& f, const Frame& g) { return {f.axes * g.axes}; }
  static Frame then_back(const Frame& f, const Frame& g) { return {f.axes * transpose(g.axes)}; }
  static Frame rotation(const Spin& theta) { return {rotation_matrix(theta)}; }
  static Spin angle_from(const Frame& f, const Frame& g) {
    return rotation_vector(transpose(f.axes) * g.axes);
  }
  static Point spun(const Spin& w, const Point& arm) { return cross(w, arm); }
  static Spin moment(const Point& arm, const Point& force) { return cross(arm, force); }
  static Mat<S, 3, 3> axes(const Frame& f) { return f.axes; }
  static Mat<S, 3, 3> turn_matrix(const Frame& f) { return f.axes; }
  static Mat<S, 3, 3> spun_by(const Point& arm) { return skew(-arm); }
  static Mat<S, 3, 3> moment_by(const Point& arm, const Point& force) {
    return skew(force) * skew(arm);
  }
  static Mat<S, 3, 3> turned_by(const Spin& moment) { return skew(-moment); }
  static Spin turn_by(const Spin& spin, const Spin& theta) {
    return theta + inverse_tangent_map(theta, RotationCoefficients<S>(dot(theta, theta))) * spin;
  }
};

}  // namespace plastica::chain
