#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "plastica/chain/inverse.hpp"
#include "plastica/chain/placement.hpp"
#include "plastica/solve/segment_motion.hpp"

/// The momentum of pieces of a beam: README.md, "Momentum".
namespace plastica::solve {

/// Momentum of the segments of a piece, and what its changes are small against.
template <class L>
struct PieceMotion {
  using S = typename L::Scalar;
  S mass{};
  typename L::Point center{};    ///< of mass [m]
  typename L::Point momentum{};  ///< [N s]
  typename L::Spin turning{};    ///< angular momentum about the center of mass [N m s]
  double size = 0.0;             ///< sum of the sizes of the segments' momenta [N s]
  double turning_size = 0.0;     ///< the same of their angular momenta about the center [N m s]
};

/// @param first, end  segments of the piece, `end` not included
template <class L>
PieceMotion<L> piece_motion(const std::vector<chain::Inertia<L>>& inertias,
                            const chain::Placement<L>& placement,
                            const std::vector<SegmentMotion<L>>& motion, std::size_t first,
                            std::size_t end) {
  using S = typename L::Scalar;
  PieceMotion<L> piece;
  for (std::size_t i = first; i < end; ++i) {
    const S mass = inertias[i].mass;
    piece.mass = piece.mass + mass;
    piece.center += mass * placement.point(i, inertias[i].center);
    piece.momentum += mass * motion[i].velocity;
    piece.size += size_of(mass * motion[i].velocity);
  }
  const S fraction = constant<S>(1) / piece.mass;
  piece.center = fraction * piece.center;
  const typename L::Point mean = fraction * piece.momentum;
  for (std::size_t i = first; i < end; ++i) {
    const typename L::Point arm = placement.point(i, inertias[i].center) - piece.center;
    const typename L::Spin own = L::moment(arm, inertias[i].mass * (motion[i].velocity - mean)) +
                                 turning_momentum(inertias[i], placement.frame[i], motion[i].spin);
    piece.turning += own;
    piece.turning_size += size_of(own);
  }
  return piece;
}

/// Adds the rigid motion of a piece that has a given momentum.
/// @param about     point that the angular momentum is about
/// @param momentum  of the motion that is added, and its angular momentum
template <class L>
void add_momentum(const std::vector<chain::Inertia<L>>& inertias,
                  const chain::Placement<L>& placement, const typename L::Point& about,
                  const chain::Wrench<L>& momentum, std::size_t first, std::size_t end,
                  std::vector<SegmentMotion<L>>& motion) {
  using S = typename L::Scalar;
  constexpr std::size_t kR = L::kRotations;
  constexpr std::size_t kT = L::kTranslations;
  chain::Impedance<L> a{};
  const auto arm_of = [&](std::size_t i) { return placement.point(i, inertias[i].center) - about; };
  for (std::size_t i = first; i < end; ++i) {
    const S mass = inertias[i].mass;
    const auto by = L::spun_by(arm_of(i));
    const auto axes = L::axes(placement.frame[i]);
    for (std::size_t k = 0; k < kT; ++k) a.tt(k, k) = a.tt(k, k) + mass;
    a.tr += mass * by;
    a.rt += mass * transpose(by);
    a.rr += axes * inertias[i].turning * transpose(axes) + mass * (transpose(by) * by);
  }
  Mat<S, kR + kT, kR + kT> m;
  put(m, 0, 0, a.rr);
  put(m, 0, kR, a.rt);
  put(m, kR, 0, a.tr);
  put(m, kR, kR, a.tt);
  Vec<S, kR + kT> right;
  for (std::size_t k = 0; k < kR; ++k) right[k] = momentum.moment[k];
  for (std::size_t k = 0; k < kT; ++k) right[kR + k] = momentum.force[k];
  const Vec<S, kR + kT> moves = chain::inverse(m) * right;
  typename L::Spin spin;
  typename L::Point shift;
  for (std::size_t k = 0; k < kR; ++k) spin[k] = moves[k];
  for (std::size_t k = 0; k < kT; ++k) shift[k] = moves[kR + k];
  for (std::size_t i = first; i < end; ++i) {
    motion[i].velocity += shift + L::spun(spin, arm_of(i));
    motion[i].spin += transposed_times(L::axes(placement.frame[i]), spin);
  }
}

/// What a piece's momentum has changed by beyond the impulses of its loads, so far.
template <class L>
struct MomentumError {
  typename L::Point lost{};     ///< [N s]
  typename L::Spin turned{};    ///< [N m s]
  double largest_lost = 0.0;    ///< of them, so far
  double largest_turned = 0.0;  ///< likewise
  double size = 0.0;            ///< `PieceMotion::size`, the largest so far
  double turning_size = 0.0;    ///< likewise
  chain::Wrench<L> outside{};   ///< what acted on it at the step's begin, about its center
  bool knows_outside = false;

  /// The largest over the largest momentum so far [1].
  /// @param length  of the beam [m]
  double fraction(double length) const {
    // A piece that hardly turns has no angular momentum but rounding.
    constexpr double kNoTurning = kIsDouble<typename L::Scalar> ? 1e-9 : 1e-3;
    const double turning = std::max(turning_size, kNoTurning * size * length);
    return std::max(size > 0.0 ? largest_lost / size : 0.0,
                    turning > 0.0 ? largest_turned / turning : 0.0);
  }
};

}  // namespace plastica::solve
