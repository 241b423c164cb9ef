#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/chain/level.hpp"
#include "plastica/lanes/articulated_body.hpp"
#include "plastica/lanes/entry.hpp"
#include "plastica/lanes/spatial_beam.hpp"

namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// What articulated_step.hpp and articulated_observables.hpp ask of straight beams in space. The
/// energy of a joint is that of three springs along the components of the rotation vector, each of
/// which may yield on its own, so that its moments m are those of three planar joints; B, the rows
/// that turn a joint's rate into its angle's, brings them to world axes: moment B^T m, resistance
/// B^T diag(k) B. As the angle goes by h B (mean rate), what the moments do in a step is exactly
/// what the springs store.
/// @tparam kStride  lanes of the beams' memory
template <class S, std::size_t kStride>
struct SpatialForm {
  using Scalar = S;
  using L = chain::Spatial<S>;
  using Beam = SpatialBeam<real_t<S>>;
  using Kind = ConstantEntry<S, SpatialKind, kStride>;
  using Load = ConstantEntry<S, SpatialLoad, kStride>;
  using State = Entry<S, SpatialState, kStride>;
  using Work = Entry<S, SpatialWork, kStride>;
  using Observables = Entry<S, SpatialObservables, kStride>;
  using Sums = Entry<S, SpatialSums, kStride>;
  using Body = ArticulatedBody<L>;
  using Vector = Vec<S, 3>;

  /// A segment at the end of a step and, by its frame, where the next step's forces act.
  struct Aim {
    typename L::Frame frame{};
    Vector spin{};
  };
  struct Axes {
    Vector along, y;  ///< its axes z and y
  };
  /// Goes on to the next segment, beyond a joint of that angle.
  PLASTICA_ALWAYS_INLINE static Axes rotated(const Kind& /*kind*/, const Vector& angle, Aim& aim) {
    assign(L::compose(aim.frame, L::rotation(angle)).axes, aim.frame.axes);
    return {column<3>(aim.frame.axes, 2), column<3>(aim.frame.axes, 1)};
  }
  PLASTICA_ALWAYS_INLINE static void observe(const Aim& aim, const Axes& /*axes*/,
                                             const Observables& observables) {
    for_each_of<3>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      set_vec(observables, SpatialObservables::Axes + 3 * k, column<3>(aim.frame.axes, k));
    });
  }
  /// Foretells the joint's angle by its mean rate. With T^-1 of chain/rotation.hpp, for a spin in
  /// the axes R of the joint's inner side, B = T^-1 R^T.
  PLASTICA_ALWAYS_INLINE static void aim(const Kind& kind, const Work& work, const S& ahead,
                                         const Vector& angle, const Vector& angle_rate, Aim& aim) {
    const Vector theta = scale_add(ahead, angle_rate, angle);
    const Mat<S, 3, 3> to_angle =
        chain::inverse_tangent_map(theta, chain::RotationCoefficients<S>(dot(theta, theta)));
    const Mat<S, 3, 3> rows = to_angle * transpose(aim.frame.axes);
    set_vec(work, SpatialWork::AngleX, Vec<S, 9>{rows.at});
    const Axes axes = rotated(kind, theta, aim);
    set_vec(work, SpatialWork::AxisZ, axes.along);
    set_vec(work, SpatialWork::AxisY, axes.y);
  }

  /// A segment where the step's forces act.
  struct Place : Axes {
    Vector spin;
    Vector centripetal;  ///< acceleration over the distance from the joint [1/s^2]

    PLASTICA_ALWAYS_INLINE explicit Place(const Work& work)
        : Axes{get_vec<3>(work, SpatialWork::AxisZ), get_vec<3>(work, SpatialWork::AxisY)},
          spin(get_vec<3>(work, SpatialWork::Spin)),
          centripetal(scale_add(dot(spin, this->along), spin, -dot(spin, spin) * this->along)) {}
  };

  /// Its inertia is Ix + (Iy - Ix) y y^T + (Iz - Ix) z z^T, of which only the last two have a
  /// gyroscopic moment.
  PLASTICA_ALWAYS_INLINE static void add_inertia(const Kind& kind, const Place& at, Body& a) {
    const Vector& y = at.y;
    const Vector& z = at.along;
    const S across = kind.get(SpatialKind::Inertia);
    const S more_y = kind.get(SpatialKind::Inertia + 1) - across;
    const S more_z = kind.get(SpatialKind::Inertia + 2) - across;
    add_square(more_z, z, a.rr);
    add_square(more_y, y, a.rr);
    for_each_of<3>([&](std::size_t k) PLASTICA_ALWAYS_INLINE { a.rr(k, k) += across; });
    const S along = more_z * dot(at.spin, z);
    const Vector momentum = scale_add(more_y * dot(at.spin, y), y, along * z);
    a.r += cross(at.spin, momentum);
    const Vector arm = kind.get(SpatialKind::FirstMoment) * z;
    a.rt(1, 0) += arm[2];
    a.rt(2, 0) -= arm[1];
    a.rt(0, 1) -= arm[2];
    a.rt(2, 1) += arm[0];
    a.rt(0, 2) += arm[1];
    a.rt(1, 2) -= arm[0];
  }
  /// turning . inertia turning.
  PLASTICA_ALWAYS_INLINE static S spun(const Kind& kind, const Axes& at,
                                       const Vector& angular_acceleration) {
    const S across = kind.get(SpatialKind::Inertia);
    const S by_y = dot(at.y, angular_acceleration);
    const S by_z = dot(at.along, angular_acceleration);
    return across * dot(angular_acceleration, angular_acceleration) +
           ((kind.get(SpatialKind::Inertia + 1) - across) * by_y * by_y +
            (kind.get(SpatialKind::Inertia + 2) - across) * by_z * by_z);
  }

  PLASTICA_ALWAYS_INLINE static Vector angle_rate(const Work& work, const Vector& rate) {
    return rows_of_angle(work) * rate;
  }
  PLASTICA_ALWAYS_INLINE static JointMoment<L> in_world(const Kind& /*kind*/, const Work& work,
                                                        const Vector& moment,
                                                        const Vector& resistance) {
    const Mat<S, 3, 3> b = rows_of_angle(work);
    JointMoment<L> joint{transposed_times(b, moment), {}};
    for_each_of<3>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      add_square(resistance[k], row<3>(b, k), joint.resistance);
    });
    return joint;
  }
  PLASTICA_ALWAYS_INLINE static S free(const Kind& kind) { return kind.get(SpatialKind::Free); }

 private:
  PLASTICA_ALWAYS_INLINE static Mat<S, 3, 3> rows_of_angle(const Work& work) {
    return {get_vec<9>(work, SpatialWork::AngleX).at};
  }
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
