#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/joint_component.hpp"
#include "plastica/lanes/spatial_beam.hpp"
#include "plastica/lanes/spatial_body.hpp"

/// Joints of the spatial kernels. The energy is that of three springs along the components of the
/// rotation vector, each of which may yield on its own, so that the moments of the scheme are those
/// of three planar joints; B, the rows that turn a joint's rate into its angle's, brings them to
/// world axes: moment B^T m, resistance B^T diag(k) B. As the angle goes by h B (mean rate), what
/// the moments do in a step is exactly what the springs store.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

template <class S, std::size_t kStride, int kOrder, bool kYields>
class SpatialJoints {
 public:
  using Kind = ConstantEntry<S, SpatialKind, kStride>;
  using State = Entry<S, SpatialState, kStride>;
  using Vector = Triple<S>;

  PLASTICA_ALWAYS_INLINE explicit SpatialJoints(double step) : components_(step) {}

  /// @param b  rows of B
  PLASTICA_ALWAYS_INLINE JointMoment<S> moment(const Kind& kind, const State& state,
                                               const Columns<S>& b) const {
    const Vector rate = rows_times(b, get_triple(state, SpatialState::Rate));
    const ComponentMoment<S> x = components_.moment(kind, state, rate.x, 0);
    const ComponentMoment<S> y = components_.moment(kind, state, rate.y, 1);
    const ComponentMoment<S> z = components_.moment(kind, state, rate.z, 2);
    const S zero = constant<S>(0);
    const Symmetric<S> none{zero, zero, zero, zero, zero, zero};
    return {columns_times(b, Vector{x.moment, y.moment, z.moment}),
            square_add(x.resistance, b.x,
                       square_add(y.resistance, b.y, square_add(z.resistance, b.z, none)))};
  }

  /// Counts what a step has dissipated; lets what is beyond its cap flow.
  /// @param rate  mean of the angle's
  PLASTICA_ALWAYS_INLINE void settle(const Kind& kind, const State& state, const Vector& before,
                                     const Vector& angle, const Vector& rate,
                                     Losses<S>& losses) const {
    components_.settle(kind, state, 0, before.x, angle.x, rate.x, losses);
    components_.settle(kind, state, 1, before.y, angle.y, rate.y, losses);
    components_.settle(kind, state, 2, before.z, angle.z, rate.z, losses);
  }

 private:
  JointComponents<S, kOrder, kYields, Kind, State> components_;
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
