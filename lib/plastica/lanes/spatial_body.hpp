#pragma once

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/spatial_beam.hpp"
#include "plastica/lanes/triple.hpp"

/// Bodies of the spatial recursion: a segment with all outside of it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// A symmetric positive definite matrix as L diag(1/pivots) L^T. Its inverse by minors would lose
/// as many digits across a slender beam as its twist does.
template <class S>
struct Factored {
  S yx, zx, zy;  ///< of L
  Triple<S> inverse;

  /// @param free  1; 0 makes the inverse 0
  PLASTICA_ALWAYS_INLINE Factored(const Symmetric<S>& m, const S& free) {
    inverse.x = free / m.xx;
    yx = m.xy * inverse.x;
    zx = m.xz * inverse.x;
    const S pivot_y = multiply_add(-yx, m.xy, m.yy);
    const S rest = multiply_add(-zx, m.xy, m.yz);
    inverse.y = free / pivot_y;
    zy = rest * inverse.y;
    inverse.z = free / multiply_add(-zy, rest, multiply_add(-zx, m.xz, m.zz));
  }
  /// L^-1 v.
  PLASTICA_ALWAYS_INLINE Triple<S> forward(const Triple<S>& v) const {
    const S y = multiply_add(-yx, v.x, v.y);
    return {v.x, y, multiply_add(-zy, y, multiply_add(-zx, v.x, v.z))};
  }
  PLASTICA_ALWAYS_INLINE Triple<S> scaled(const Triple<S>& v) const {
    return {inverse.x * v.x, inverse.y * v.y, inverse.z * v.z};
  }
  /// L^-T v.
  PLASTICA_ALWAYS_INLINE Triple<S> backward(const Triple<S>& v) const {
    const S y = multiply_add(-zy, v.z, v.y);
    return {multiply_add(-yx, y, multiply_add(-zx, v.z, v.x)), y, v.z};
  }
  PLASTICA_ALWAYS_INLINE Triple<S> solved(const Triple<S>& v) const {
    return backward(scaled(forward(v)));
  }
};

/// How a joint resists: its moment is `moment` less `resistance` times the joint's acceleration.
template <class S>
struct JointMoment {
  Triple<S> moment;
  Symmetric<S> resistance;
};

/// What acts on a body at its joint, in world axes:
///   moment = rr turning + rt acceleration + r,  force = rt^T turning + tt acceleration + t.
template <class S>
struct SpatialBody {
  Symmetric<S> rr;
  Columns<S> rt;
  Symmetric<S> tt;
  Triple<S> r, t;

  PLASTICA_ALWAYS_INLINE static SpatialBody none() {
    const S zero = constant<S>(0);
    const Triple<S> v{zero, zero, zero};
    const Symmetric<S> m{zero, zero, zero, zero, zero, zero};
    return {m, {v, v, v}, m, v, v};
  }

  /// The same about another joint, of which the first accelerates by turning x e + pull. Column k
  /// of rt gets e x column k of tt; rr gets that of rt's rows before and after.
  PLASTICA_ALWAYS_INLINE void carry(const Triple<S>& e, const Triple<S>& pull) {
    const Columns<S> columns = tt.columns();
    r = columns_add(rt, pull, r);
    t = columns_add(columns, pull, t);
    r = cross_add(e, t, r);
    turn_rows(e, rt, rr);
    rt = {cross_add(e, columns.x, rt.x), cross_add(e, columns.y, rt.y),
          cross_add(e, columns.z, rt.z)};
    turn_rows_transposed(e, rt, rr);
  }

  /// Eliminates the joint's acceleration: it is given - by_turning (turning of the inner
  /// neighbour) - by_acceleration (acceleration of the joint), which the sink takes, the last two
  /// by columns. With resistance k and D = rr + k, what is left of rr is rr - rr D^-1 rr = k D^-1
  /// rr, without a difference of large numbers; likewise of rt.
  /// @param free  0 for a welded joint, whose body may not be carried on then
  template <class Sink>
  PLASTICA_ALWAYS_INLINE void release(const JointMoment<S>& joint, const S& free,
                                      const Sink& sink) {
    const Factored<S> d(rr + joint.resistance, free);
    const Columns<S> k = joint.resistance.columns();
    const Columns<S> whole = rr.columns();
    const Triple<S> given = d.solved(joint.moment - r);
    sink.given(given);
    r = columns_add(whole, given, r);
    t = t + rows_times(rt, given);
    // Column by column, each put away once it is used: registers are short.
    const Triple<S> by_x = d.solved(whole.x);
    sink.by_turning(0, by_x);
    rr.xx = dot(k.x, by_x);
    const S rr_xy = dot(k.y, by_x);
    const S rr_xz = dot(k.z, by_x);
    const Triple<S> by_y = d.solved(whole.y);
    sink.by_turning(1, by_y);
    const S rr_yy = dot(k.y, by_y);
    const S rr_yz = dot(k.z, by_y);
    const Triple<S> by_z = d.solved(whole.z);
    sink.by_turning(2, by_z);
    rr = {rr.xx, rr_xy, rr_xz, rr_yy, rr_yz, dot(k.z, by_z)};
    const Triple<S> z = d.solved(rt.z);
    sink.by_acceleration(2, z);
    tt.xz = dot_add(-z, rt.x, tt.xz);
    tt.yz = dot_add(-z, rt.y, tt.yz);
    tt.zz = dot_add(-z, rt.z, tt.zz);
    rt.z = rows_times(k, z);
    const Triple<S> y = d.solved(rt.y);
    sink.by_acceleration(1, y);
    tt.xy = dot_add(-y, rt.x, tt.xy);
    tt.yy = dot_add(-y, rt.y, tt.yy);
    rt.y = rows_times(k, y);
    const Triple<S> x = d.solved(rt.x);
    sink.by_acceleration(0, x);
    tt.xx = dot_add(-x, rt.x, tt.xx);
    rt.x = rows_times(k, x);
  }

 private:
  /// Adds e x row i of m, of its component j, to the entry ij.
  PLASTICA_ALWAYS_INLINE static void turn_rows(const Triple<S>& e, const Columns<S>& m,
                                               Symmetric<S>& to) {
    to.xx = across(e.y, m.z.x, e.z, m.y.x, to.xx);
    to.xy = across(e.z, m.x.x, e.x, m.z.x, to.xy);
    to.xz = across(e.x, m.y.x, e.y, m.x.x, to.xz);
    to.yy = across(e.z, m.x.y, e.x, m.z.y, to.yy);
    to.yz = across(e.x, m.y.y, e.y, m.x.y, to.yz);
    to.zz = across(e.x, m.y.z, e.y, m.x.z, to.zz);
  }
  /// The same to the entry ji.
  PLASTICA_ALWAYS_INLINE static void turn_rows_transposed(const Triple<S>& e, const Columns<S>& m,
                                                          Symmetric<S>& to) {
    to.xx = across(e.y, m.z.x, e.z, m.y.x, to.xx);
    to.xy = across(e.y, m.z.y, e.z, m.y.y, to.xy);
    to.xz = across(e.y, m.z.z, e.z, m.y.z, to.xz);
    to.yy = across(e.z, m.x.y, e.x, m.z.y, to.yy);
    to.yz = across(e.z, m.x.z, e.x, m.z.z, to.yz);
    to.zz = across(e.x, m.y.z, e.y, m.x.z, to.zz);
  }

  /// a b - c d + sum.
  PLASTICA_ALWAYS_INLINE static S across(const S& a, const S& b, const S& c, const S& d,
                                         const S& sum) {
    return multiply_add(a, b, multiply_add(-c, d, sum));
  }
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
