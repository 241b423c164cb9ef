#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/chain/level.hpp"
#include "plastica/lanes/articulated_body.hpp"
#include "plastica/lanes/entry.hpp"
#include "plastica/lanes/planar_beam.hpp"

namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// What articulated_step.hpp and articulated_observables.hpp ask of beams in a plane.
/// @tparam kStride  lanes of the beams' memory
template <class S, std::size_t kStride>
struct PlanarForm {
  using Scalar = S;
  using L = chain::Planar<S>;
  using Beam = PlanarBeam<real_t<S>>;
  using Kind = ConstantEntry<S, PlanarKind, kStride>;
  using Load = ConstantEntry<S, PlanarLoad, kStride>;
  using State = Entry<S, PlanarState, kStride>;
  using Work = Entry<S, PlanarWork, kStride>;
  using Observables = Entry<S, PlanarObservables, kStride>;
  using Sums = Entry<S, PlanarSums, kStride>;
  using Body = ArticulatedBody<L>;
  using Point = typename L::Point;
  using Spin = typename L::Spin;

  /// A segment at the end of a step.
  struct Aim {
    S direction{};
    Spin spin{};
  };
  struct Axes {
    Point along;  ///< unit vector
  };
  /// Goes on to the next segment, beyond a joint of that angle.
  /// @param ahead  to look ahead by, with the segment's spin [s]
  PLASTICA_ALWAYS_INLINE static Axes rotated(const Kind& kind, const Spin& angle, Aim& aim,
                                             const S& ahead = S{}) {
    aim.direction += kind.get(PlanarKind::Rest) + angle[0];
    const auto at = L::rotation({{ahead * aim.spin[0] + aim.direction}});
    return {{{at.cosine, at.sine}}};
  }
  PLASTICA_ALWAYS_INLINE static void observe(const Aim& aim, const Axes& axes,
                                             const Observables& observables) {
    observables.set(PlanarObservables::Direction, aim.direction);
    set_vec(observables, PlanarObservables::Cosine, axes.along);
  }
  /// Foretells the segment's direction by its spin.
  PLASTICA_ALWAYS_INLINE static void aim(const Kind& kind, const Work& work, const S& ahead,
                                         const Spin& angle, const Spin& /*angle_rate*/, Aim& aim) {
    set_vec(work, PlanarWork::Cosine, rotated(kind, angle, aim, ahead).along);
  }

  /// A segment where the step's forces act.
  struct Place : Axes {
    Spin spin;
    Point centripetal;  ///< acceleration over the distance from the joint [1/s^2]

    PLASTICA_ALWAYS_INLINE explicit Place(const Work& work)
        : Axes{get_vec<2>(work, PlanarWork::Cosine)},
          spin(get_vec<1>(work, PlanarWork::Spin)),
          centripetal(-(spin[0] * spin[0]) * this->along) {}
  };

  PLASTICA_ALWAYS_INLINE static void add_inertia(const Kind& kind, const Place& at, Body& a) {
    const Point arm = kind.get(PlanarKind::FirstMoment) * at.along;
    a.rr(0, 0) += kind.get(PlanarKind::Inertia);
    a.rt(0, 0) -= arm[1];
    a.rt(0, 1) += arm[0];
  }
  /// turning . inertia turning.
  PLASTICA_ALWAYS_INLINE static S spun(const Kind& kind, const Axes& /*at*/,
                                       const Spin& angular_acceleration) {
    return kind.get(PlanarKind::Inertia) * angular_acceleration[0] * angular_acceleration[0];
  }

  PLASTICA_ALWAYS_INLINE static Spin angle_rate(const Work& /*work*/, const Spin& rate) {
    return rate;
  }
  PLASTICA_ALWAYS_INLINE static JointMoment<L> in_world(const Kind& kind, const Work& /*work*/,
                                                        const Spin& moment,
                                                        const Spin& resistance) {
    return {moment, {{resistance[0] + kind.get(PlanarKind::Hold)}}};
  }
  PLASTICA_ALWAYS_INLINE static S free(const Kind& /*kind*/) { return constant<S>(1); }
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
