#pragma once

#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/base/sine_cosine.hpp"
#include "plastica/chain/rotation.hpp"

/// The algebra of rigid motion at each level of modelling: what differs between a twisted, a
/// planar and a spatial chain. All that follows (kinematics, recursion, solver) is written once.
///
/// A pose is a point and a frame. Small motions of a segment are (translation of its inner joint,
/// spin), wrenches (force, moment about the inner joint); both in world axes.
/// Each level has: kTranslations, kRotations, Point, Spin, Frame, and
///   rotate(frame, local), rotate_back(frame, world)   a vector to and from world axes;
///   compose(frame, local)                         the frame `local` seen from `frame`;
///   compose_inverse(frame, local)                 frame times the inverse of `local`;
///   rotation(theta)                               the frame turned by a rotation vector;
///   angle_from(frame, other)                      the rotation vector from one to the other, in
///                                                 the first's axes;
///   spun(spin, arm)                               velocity of the end of an arm;
///   moment(arm, force)                            arm x force;
///   axes(frame)                                   spins in the frame's axes to world axes;
///   frame_matrix(frame)                            the matrix of `rotate`;
///   spun_by(arm)          d(arm) / d(spin), the arm being fixed to a segment;
///   moment_by(arm, force) d(arm x force) / d(spin) at constant force;
///   spin_derivative(moment)     d(moment) / d(spin), the moment being fixed to the segment;
///   add_rotation(spin, theta)  the rotation vector after a small spin;
///   step_spin(f, g)       the finite spin s of a step from frame f to g by Cayley's map:
///                         g - f = s x (f + g)/2 for every axis of the frames;
///   step_spin_slope(s)    d s / d (spin of g), both in the axes of g (or f: s is the same);
///   select(mask, f, g)    f where the mask holds, g elsewhere;
///   mean(f, g)            of the axes of two frames; not a rotation;
///   work_to_joint(a, b), work_from_joint(a, b)   a moment in world axes to what works on the step
///                         spin of the outer side as seen from the inner one, in the inner side's
///                         axes at the step's begin less their turn to the world, and back; a, b
///                         are the step spins of the inner and the outer side.
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

  static Point rotate(const Frame& /*frame*/, const Point& local) { return local; }
  static Point rotate_back(const Frame& /*frame*/, const Point& world) { return world; }
  static Frame compose(const Frame& frame, const Frame& local) {
    return {frame.angle + local.angle};
  }
  static Frame compose_inverse(const Frame& frame, const Frame& local) {
    return {frame.angle - local.angle};
  }
  static Frame rotation(const Spin& theta) { return {theta[0]}; }
  static Spin angle_from(const Frame& f, const Frame& g) { return {{g.angle - f.angle}}; }
  static Point spun(const Spin& /*spin*/, const Point& arm) { return arm; }
  static Spin moment(const Point& /*arm*/, const Point& /*force*/) { return {}; }
  static Mat<S, 1, 1> axes(const Frame& /*frame*/) { return identity<S, 1>(); }
  static Mat<S, 0, 1> spun_by(const Point& /*arm*/) { return {}; }
  static Mat<S, 1, 1> moment_by(const Point& /*arm*/, const Point& /*force*/) { return {}; }
  static Mat<S, 1, 1> spin_derivative(const Spin& /*moment*/) { return {}; }
  static Spin add_rotation(const Spin& spin, const Spin& theta) { return theta + spin; }
  static Spin step_spin(const Frame& f, const Frame& g) { return angle_from(f, g); }
  static Mat<S, 1, 1> step_spin_slope(const Spin& /*s*/) { return identity<S, 1>(); }
  static Frame select(const mask_t<S>& mask, const Frame& f, const Frame& g) {
    return {plastica::select(mask, f.angle, g.angle)};
  }
  static Frame mean(const Frame& f, const Frame& g) {
    return {constant<S>(0.5) * (f.angle + g.angle)};
  }
  static Mat<S, 1, 1> work_to_joint(const Spin& /*a*/, const Spin& /*b*/) {
    return identity<S, 1>();
  }
  static Mat<S, 1, 1> work_from_joint(const Spin& /*a*/, const Spin& /*b*/) {
    return identity<S, 1>();
  }
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

  static Point rotate(const Frame& f, const Point& p) {
    return {{f.cosine * p[0] - f.sine * p[1], f.sine * p[0] + f.cosine * p[1]}};
  }
  static Point rotate_back(const Frame& f, const Point& p) {
    return {{f.cosine * p[0] + f.sine * p[1], f.cosine * p[1] - f.sine * p[0]}};
  }
  static Frame compose(const Frame& f, const Frame& g) {
    return {f.angle + g.angle, f.cosine * g.cosine - f.sine * g.sine,
            f.sine * g.cosine + f.cosine * g.sine};
  }
  static Frame compose_inverse(const Frame& f, const Frame& g) {
    return {f.angle - g.angle, f.cosine * g.cosine + f.sine * g.sine,
            f.sine * g.cosine - f.cosine * g.sine};
  }
  static Frame rotation(const Spin& theta) {
    const SineCosine<S, false> rotated(theta[0]);
    return {theta[0], rotated.cosine, rotated.sine};
  }
  static Spin angle_from(const Frame& f, const Frame& g) { return {{g.angle - f.angle}}; }
  static Point spun(const Spin& w, const Point& arm) { return {{-(w[0] * arm[1]), w[0] * arm[0]}}; }
  static Spin moment(const Point& arm, const Point& force) {
    return {{arm[0] * force[1] - arm[1] * force[0]}};
  }
  static Mat<S, 1, 1> axes(const Frame& /*f*/) { return identity<S, 1>(); }
  static Mat<S, 2, 2> frame_matrix(const Frame& f) {
    return {{f.cosine, -f.sine, f.sine, f.cosine}};
  }
  static Mat<S, 2, 1> spun_by(const Point& arm) { return {{-arm[1], arm[0]}}; }
  static Mat<S, 1, 1> moment_by(const Point& arm, const Point& force) {
    return {{-dot(arm, force)}};
  }
  static Mat<S, 1, 1> spin_derivative(const Spin& /*moment*/) { return {}; }
  static Spin add_rotation(const Spin& spin, const Spin& theta) { return theta + spin; }
  static Spin step_spin(const Frame& f, const Frame& g) {
    const S cosine = f.cosine * g.cosine + f.sine * g.sine;
    const S sine = f.cosine * g.sine - f.sine * g.cosine;
    return {{constant<S>(2) * sine / (constant<S>(1) + cosine)}};
  }
  static Mat<S, 1, 1> step_spin_slope(const Spin& s) {
    return {{constant<S>(1) + constant<S>(0.25) * s[0] * s[0]}};
  }
  static Frame select(const mask_t<S>& mask, const Frame& f, const Frame& g) {
    return {plastica::select(mask, f.angle, g.angle), plastica::select(mask, f.cosine, g.cosine),
            plastica::select(mask, f.sine, g.sine)};
  }
  static Frame mean(const Frame& f, const Frame& g) {
    const S half = constant<S>(0.5);
    return {half * (f.angle + g.angle), half * (f.cosine + g.cosine), half * (f.sine + g.sine)};
  }
  /// tan(b - a) = (tan b - tan a)/(1 + tan a tan b), of half the angles.
  static Mat<S, 1, 1> work_to_joint(const Spin& a, const Spin& b) {
    return {{constant<S>(1) + constant<S>(0.25) * a[0] * b[0]}};
  }
  static Mat<S, 1, 1> work_from_joint(const Spin& a, const Spin& b) {
    return {{constant<S>(1) / work_to_joint(a, b)(0, 0)}};
  }
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

  static Point rotate(const Frame& f, const Point& p) { return f.axes * p; }
  static Point rotate_back(const Frame& f, const Point& p) { return transposed_times(f.axes, p); }
  static Frame compose(const Frame& f, const Frame& g) { return {f.axes * g.axes}; }
  static Frame compose_inverse(const Frame& f, const Frame& g) {
    return {f.axes * transpose(g.axes)};
  }
  static Frame rotation(const Spin& theta) { return {rotation_matrix(theta)}; }
  static Spin angle_from(const Frame& f, const Frame& g) {
    return rotation_vector(transpose(f.axes) * g.axes);
  }
  static Point spun(const Spin& w, const Point& arm) { return cross(w, arm); }
  static Spin moment(const Point& arm, const Point& force) { return cross(arm, force); }
  static Mat<S, 3, 3> axes(const Frame& f) { return f.axes; }
  static Mat<S, 3, 3> frame_matrix(const Frame& f) { return f.axes; }
  static Mat<S, 3, 3> spun_by(const Point& arm) { return skew(-arm); }
  static Mat<S, 3, 3> moment_by(const Point& arm, const Point& force) {
    Mat<S, 3, 3> by = outer(arm, force);
    const S along = dot(arm, force);
    for (std::size_t i = 0; i < 3; ++i) by(i, i) = by(i, i) - along;
    return by;
  }
  static Mat<S, 3, 3> spin_derivative(const Spin& moment) { return skew(-moment); }
  static Spin add_rotation(const Spin& spin, const Spin& theta) {
    const RotationCoefficients<S> k(dot(theta, theta));
    const Spin rotated = cross(theta, spin);
    return theta + spin - constant<S>(0.5) * rotated + k.c * cross(theta, rotated);
  }
  /// Cayley: g f^T = 1 + (skew(s) + skew(s)^2/2)/(1 + s^2/4), so its axial part over 1 + trace is
  /// s/4.
  static Spin step_spin(const Frame& f, const Frame& g) {
    const Mat<S, 3, 3> m = g.axes * transpose(f.axes);
    const S scale = constant<S>(2) / (constant<S>(1) + m(0, 0) + m(1, 1) + m(2, 2));
    return {
        {scale * (m(2, 1) - m(1, 2)), scale * (m(0, 2) - m(2, 0)), scale * (m(1, 0) - m(0, 1))}};
  }
  static Mat<S, 3, 3> step_spin_slope(const Spin& s) {
    return identity<S, 3>() + skew(constant<S>(0.5) * s) + outer(constant<S>(0.25) * s, s);
  }
  static Frame select(const mask_t<S>& mask, const Frame& f, const Frame& g) {
    return {plastica::select(mask, f.axes, g.axes)};
  }
  static Frame mean(const Frame& f, const Frame& g) {
    return {constant<S>(0.5) * (f.axes + g.axes)};
  }
  /// Rodrigues' composition: with half spins a and b the relative one is
  /// (b - a - a x b)/(1 + a.b) = (1 - skew(a)) (b - a)/(1 + a.b), so moments go back by
  /// (1 + skew(a))/(1 + a.b).
  static Mat<S, 3, 3> work_to_joint(const Spin& a, const Spin& b) {
    const S half = constant<S>(0.5);
    const Spin x = half * a;
    const S one = constant<S>(1);
    const S scale = (one + half * dot(x, b)) / (one + dot(x, x));
    return scale * (identity<S, 3>() - skew(x) + outer(x, x));
  }
  static Mat<S, 3, 3> work_from_joint(const Spin& a, const Spin& b) {
    const S scale = constant<S>(1) / (constant<S>(1) + constant<S>(0.25) * dot(a, b));
    return scale * (identity<S, 3>() + skew(constant<S>(0.5) * a));
  }
};

}  // namespace plastica::chain
