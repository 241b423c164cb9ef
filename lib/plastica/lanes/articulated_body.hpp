#pragma once

#include <cstddef>

#include "plastica/base/always_inline.hpp"
#include "plastica/lanes/rigid_algebra.hpp"

/// Bodies of the recursion: a segment with all outside of it.
namespace plastica::lanes {
PLASTICA_KERNELS_BEGIN

/// A symmetric positive definite matrix as L diag(1/inverse) L^T. Its inverse by minors would lose
/// as many digits across a slender beam as its twist does.
template <class S, std::size_t N>
class Factored {
 public:
  /// @param free  1; 0 makes the inverse 0
  PLASTICA_ALWAYS_INLINE Factored(const Symmetric<S, N>& m, const S& free) {
    Mat<S, N, N> scaled;  // the columns of L times their pivots
    for_each_of<N>([&](std::size_t j) PLASTICA_ALWAYS_INLINE {
      for_each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
        if (i < j) return;
        S rest = m(i, j);
        for_each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
          if (k < j) rest -= l_(j, k) * scaled(i, k);
        });
        scaled(i, j) = rest;
      });
      inverse_[j] = free / scaled(j, j);
      for_each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
        if (i > j) l_(i, j) = scaled(i, j) * inverse_[j];
      });
    });
  }
  PLASTICA_ALWAYS_INLINE Vec<S, N> solved(Vec<S, N> v) const {
    for_each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      for_each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
        if (k < i) v[i] -= l_(i, k) * v[k];
      });
    });
    for_each_of<N>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { v[i] = v[i] * inverse_[i]; });
    for_each_of<N>([&](std::size_t down) PLASTICA_ALWAYS_INLINE {
      const std::size_t i = N - 1 - down;
      for_each_of<N>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
        if (k > i) v[i] -= l_(k, i) * v[k];
      });
    });
    return v;
  }

 private:
  Mat<S, N, N> l_;
  Vec<S, N> inverse_;
};

/// How a joint resists: its moment is `moment` less `resistance` times the joint's acceleration.
template <class L>
struct JointMoment {
  typename L::Spin moment;
  Symmetric<typename L::Scalar, L::kRotations> resistance;
};

/// What acts on a body at its joint, in world axes:
///   moment = rr turning + rt acceleration + r,  force = rt^T turning + tt acceleration + t.
/// @tparam L  a level of chain/level.hpp
template <class L>
struct ArticulatedBody {
  using S = typename L::Scalar;
  using Spin = typename L::Spin;
  using Point = typename L::Point;
  static constexpr std::size_t kR = L::kRotations;
  static constexpr std::size_t kT = L::kTranslations;

  Symmetric<S, kR> rr;
  Mat<S, kR, kT> rt;
  Symmetric<S, kT> tt;
  Spin r;
  Point t;

  /// The same about another joint, of which the first accelerates by turning x e + centripetal.
  /// Column k of rt gets e x column k of tt; rr gets that of rt's rows before and after.
  PLASTICA_ALWAYS_INLINE void carry(const Point& e, const Point& centripetal) {
    t = times_add(tt, centripetal, t);
    r = times_add(rt, centripetal, r) + L::moment(e, t);
    add_moments<false>(e);
    for_each_of<kT>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      set_column(k, column<kR>(rt, k) + L::moment(e, column<kT>(tt, k)));
    });
    add_moments<true>(e);
  }

  /// Eliminates the joint's acceleration: it is given - by_angular_acceleration (turning of the
  /// inner neighbour) - by_acceleration (acceleration of the joint), which the sink takes, the last
  /// two by columns. With resistance k and D = rr + k, what is left of rr is rr - rr D^-1 rr = k
  /// D^-1 rr, without a difference of large numbers; likewise of rt.
  /// @param free  0 for a clamped joint, whose body may not be carried on then
  template <class Sink>
  PLASTICA_ALWAYS_INLINE void release(const JointMoment<L>& joint, const S& free,
                                      const Sink& sink) {
    const Factored<S, kR> d(rr + joint.resistance, free);
    const Symmetric<S, kR> whole = rr;
    const Spin given = d.solved(joint.moment - r);
    sink.given(given);
    r = times_add(whole, given, r);
    t = transposed_times_add(rt, given, t);
    // Column by column, each put away once it is used: registers are short.
    for_each_of<kR>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const Spin by = d.solved(column<kR>(whole, k));
      sink.by_angular_acceleration(k, by);
      for_each_of<kR>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
        if (i >= k) rr(i, k) = dot(row<kR>(joint.resistance, i), by);
      });
    });
    for_each_of<kT>([&](std::size_t down) PLASTICA_ALWAYS_INLINE {
      const std::size_t k = kT - 1 - down;
      const Spin by = d.solved(column<kR>(rt, k));
      sink.by_acceleration(k, by);
      for_each_of<kT>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
        if (i <= k) tt(i, k) = dot_add(-by, column<kR>(rt, i), tt(i, k));
      });
      set_column(k, times_add(joint.resistance, by, Spin{}));
    });
  }

 private:
  /// Adds e x row i of rt, of its component j, to the entry ij of rr: of one half of these before
  /// rt is carried, of the other half after that.
  template <bool kAfter>
  PLASTICA_ALWAYS_INLINE void add_moments(const Point& e) {
    for_each_of<kR>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      const Spin moment = L::moment(e, row<kT>(rt, i));
      for_each_of<kR>([&](std::size_t j) PLASTICA_ALWAYS_INLINE {
        if (kAfter ? j <= i : i <= j) rr(i, j) += moment[j];
      });
    });
  }
  PLASTICA_ALWAYS_INLINE void set_column(std::size_t k, const Spin& v) {
    for_each_of<kR>([&](std::size_t i) PLASTICA_ALWAYS_INLINE { rt(i, k) = v[i]; });
  }
};

PLASTICA_KERNELS_END
}  // namespace plastica::lanes
