#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/each_of.hpp"
#include "plastica/base/matrix.hpp"
#include "plastica/law/gauge.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law::detail {

/// Projects, in the orthant, onto a surface of several pieces that are linear in moments and axial
/// force, by Newton's method on the pieces and bounds that hold: sequential quadratic programming,
/// its active set by the dual method of Goldfarb and Idnani (Math. Program. 27, 1983, 1).
///
/// Piece k is d_k.v <= s_k(t) with v = (m_x, m_y, n) and s_k = sqrt(1 - tau_k^2 t^2). With
/// multipliers p_k >= 0,
///   v = target - c sum p_k d_k where v > 0,  t (1 + c_t sum p_k tau_k^2/s_k) = target_t.
/// The Lagrangian's Hessian is diagonal: 1/c, and 1/c_t + sum p_k tau_k^2/s_k^3 for t. So a step
/// costs one system of as many equations as pieces hold, three at most. A piece that nothing of v
/// bears on is tau_k t <= 1.
///
/// After each step the piece that the point is furthest beyond joins, and components below zero are
/// held there; a step ends where the first multiplier would become negative, and what it belongs to
/// leaves. That takes two to four steps from just beyond the surface, six on average from four
/// times the cap. Where it does not end, or s_k is small (hardly anything but torsion), `holds`
/// says so, and another way is taken: about one target in a hundred.
template <class S, std::size_t K>
class ActivePieces {
 public:
  using Gauge = FirstYieldGauge<S, K, false>;

  /// @param overshoot  phi(target) - 1, > 0 where the mask holds
  ActivePieces(const Gauge& gauge, const SectionForce<S>& compliance, const SectionForce<S>& target,
               const S& overshoot, const mask_t<S>& mask)
      : gauge_(gauge), target_(target), active_(mask), holds_(mask) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    for_each_of<kSectionAxes>([&](std::size_t i)
                                  PLASTICA_ALWAYS_INLINE { weight_[i] = one / compliance[i]; });
    for_each_of<kMembers>([&](std::size_t m) PLASTICA_ALWAYS_INLINE {
      const auto there = target[kMember[m]] > zero;
      start_[m] = select(there, target[kMember[m]], zero);
      soft_[m] = select(there, compliance[kMember[m]], zero);
      free_[m] = soft_[m];
      point_[m] = start_[m];
    });
    put_furthest(target[kTorsion], mask);
    torque_ = target[kTorsion] / (one + overshoot);
    for (int step = 0; step < kMostSteps && any(active_); ++step) advance();
    holds_ = holds_ & !active_;
    // One more step squares the error, and gives a dual scalar its derivative.
    active_ = holds_;
    move();
  }

  /// Where the projection was found.
  const mask_t<S>& holds() const { return holds_; }

  Projection<S> result() const {
    const S zero = constant<S>(0);
    Projection<S> now;
    const S back = onto_surface();
    now.point[kTorsion] = back * next_torque_;
    // The columns of C A^T, each divided by L D^(1/2) of A C A^T: slope = (C - z z^T)/c.
    std::array<Vec<S, kSlots>, kSectionAxes> z;
    SectionForce<S> gives;
    const auto fill = [&](std::size_t i, const S& soft, const Vec<S, kSlots>& row) {
      gives[i] = soft;
      z[i][0] = soft * row[0];
      z[i][1] = soft * row[1] - l10_ * z[i][0];
      z[i][2] = soft * row[2] - l20_ * z[i][0] - l21_ * z[i][1];
    };
    const auto column = [&](const auto& of) {
      return Vec<S, kSlots>{{of(row_[0]), of(row_[1]), of(row_[2])}};
    };
    fill(kBendingX, free_[0], column([](const Row& r) { return r.x; }));
    fill(kBendingY, free_[1], column([](const Row& r) { return r.y; }));
    fill(kAxial, free_[2], column([](const Row& r) { return r.on; }));
    fill(kTorsion, soft_torsion_, column([](const Row& r) { return r.pull; }));
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const S across = z[i][0] * z[j][0] * inverse_[0] + z[i][1] * z[j][1] * inverse_[1] +
                         z[i][2] * z[j][2] * inverse_[2];
        const S both = i == j ? gives[i] - across : zero - across;
        now.slope(i, j) = both * weight_[j];
        now.slope(j, i) = both * weight_[i];
      }
    }
    std::array<S, kMembers> bend{};
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const Row& r = row_[k];
      const S nu = (r.on - r.presses) * next_[k] * next_torque_;
      bend[0] += nu * r.x * r.x;
      bend[1] += nu * r.y * r.y;
      bend[2] += nu;
    });
    for_each_of<kMembers>([&](std::size_t m) PLASTICA_ALWAYS_INLINE {
      now.point[kMember[m]] = back * max(point_[m], zero);
      // What the target lacks is kept away by a kink, or comes in against the curvature of what
      // bears on torsion alone: nu = p/tau there.
      const auto let_in = (target_[kMember[m]] <= zero) & (pull_[m] <= zero);
      const S alone = constant<S>(1) / (constant<S>(1) + bend[m] / weight_[kMember[m]]);
      now.slope(kMember[m], kMember[m]) = select(let_in, alone, now.slope(kMember[m], kMember[m]));
    });
    return now;
  }

 private:
  static constexpr std::size_t kSlots = 3;
  static constexpr std::size_t kMembers = 3;
  static constexpr std::array<std::size_t, kMembers> kMember{kBendingX, kBendingY, kAxial};
  static constexpr int kMostSteps = 30;
  static constexpr double kLeastSize = 1e-4;  ///< of s_k^2
  static constexpr double kExact = kIsDouble<S> ? 1e-13 : 1e-6;

  /// A piece that holds; all zero in a slot that is free.
  struct Row {
    S x{}, y{}, on{}, tau_squared{};  ///< on: part of n, 1
    S number{constant<S>(-1)};
    S multiplier{};
    S pull{};     ///< -d s/d t; 1 of a piece that bears on t alone
    S fresh{};    ///< 1 of the piece that came last
    S presses{};  ///< 0 of such a piece, else 1
  };

  /// What the point is multiplied by to be on the surface to its own rounding: where it was found
  /// it is to the target's.
  S onto_surface() const {
    const S one = constant<S>(1);
    S largest = constant<S>(0);
    for (const Row& r : row_) {
      const S stress = r.x * point_[0] + r.y * point_[1] + r.on * point_[2];
      largest = max(largest, stress * stress + r.tau_squared * next_torque_ * next_torque_);
    }
    return one / sqrt(select(holds_, largest, one));
  }

  /// Newton's step for the pieces and bounds that hold.
  void move() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S least = constant<S>(kLeastSize);
    S curvature = zero;
    Vec<S, kSlots> size;
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      Row& r = row_[k];
      // Nothing of v that is there bears on it: tau t <= 1.
      const auto flat = r.on * free_[2] + r.x * free_[0] + r.y * free_[1] <= zero;
      const auto twists = flat & (r.tau_squared > zero);
      const S square = one - r.tau_squared * torque_ * torque_;
      holds_ = holds_ & (flat | (square > least) | !active_);
      const S s = sqrt(select(twists, r.tau_squared, max(square, least)));
      const S inverse = one / s;
      size[k] = select(twists, inverse - torque_, s);
      r.pull = select(twists, one, r.tau_squared * torque_ * inverse);
      r.presses = select(flat, zero, r.on);
      curvature += r.presses * r.multiplier * r.tau_squared * inverse * inverse * inverse;
    });
    soft_torsion_ = one / (weight_[kTorsion] + curvature);
    const S torque = soft_torsion_ * (weight_[kTorsion] * target_[kTorsion] + curvature * torque_);
    Vec<S, kSlots> right;
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const Row& r = row_[k];
      right[k] =
          r.x * held(0) + r.y * held(1) + r.on * (held(2) - size[k]) + r.pull * (torque - torque_);
    });
    factor();
    const S a = right[0];
    const S b = right[1] - l10_ * a;
    const S c = right[2] - l20_ * a - l21_ * b;
    next_[2] = c * inverse_[2];
    next_[1] = b * inverse_[1] - l21_ * next_[2];
    next_[0] = a * inverse_[0] - l10_ * next_[1] - l20_ * next_[2];
    pull_ = {};
    S twist = zero;
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const Row& r = row_[k];
      const S press = next_[k] * r.presses;
      pull_[0] += press * r.x;
      pull_[1] += press * r.y;
      pull_[2] += press;
      twist += next_[k] * r.pull;
    });
    for_each_of<kMembers>(
        [&](std::size_t m) PLASTICA_ALWAYS_INLINE { point_[m] = held(m) - free_[m] * pull_[m]; });
    next_torque_ = torque - soft_torsion_ * twist;
  }

  /// The target of a component, zero where it is held there.
  S held(std::size_t m) const {
    return select(free_[m] > constant<S>(0), start_[m], constant<S>(0));
  }

  S product(const Row& a, const Row& b) const {
    return free_[0] * a.x * b.x + free_[1] * a.y * b.y + free_[2] * a.on * b.on +
           soft_torsion_ * a.pull * b.pull;
  }

  /// A C A^T of the rows as L D L^T; 1 on the diagonal of free slots.
  void factor() {
    const S one = constant<S>(1);
    // A piece that says what others say already has a large pivot: a small multiplier.
    const auto safe = [&](const S& pivot, std::size_t k) {
      const Row& r = row_[k];
      const S whole = product(r, r) + (one - r.on);
      spare_[k] = pivot <= constant<S>(kIsDouble<S> ? 1e-9 : 1e-4) * whole;
      return one / select(spare_[k], one, pivot);
    };
    inverse_[0] = safe(product(row_[0], row_[0]) + (one - row_[0].on), 0);
    const S a10 = product(row_[1], row_[0]);
    const S a20 = product(row_[2], row_[0]);
    l10_ = a10 * inverse_[0];
    l20_ = a20 * inverse_[0];
    inverse_[1] = safe(product(row_[1], row_[1]) + (one - row_[1].on) - l10_ * a10, 1);
    const S a21 = product(row_[2], row_[1]) - l20_ * a10;
    l21_ = a21 * inverse_[1];
    inverse_[2] = safe(product(row_[2], row_[2]) + (one - row_[2].on) - l20_ * a20 - l21_ * a21, 2);
  }

  /// A step, and what holds after it.
  void advance() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S exact = constant<S>(kExact);
    move();
    active_ = active_ & holds_;
    replace();
    // The part of the step at which the first multiplier is zero: that piece leaves.
    // One that says what others say leaves at once.
    S reach = one;
    Vec<S, kSlots> ratio;
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const S& before = row_[k].multiplier;
      const auto falls = next_[k] < -exact;
      ratio[k] = select(falls, before / select(falls, before - next_[k], one), constant<S>(2));
      ratio[k] = select(spare_[k], constant<S>(0), ratio[k]);
      reach = min(reach, ratio[k]);
    });
    std::array<S, kMembers> kappa, let_go;
    for_each_of<kMembers>([&](std::size_t m) PLASTICA_ALWAYS_INLINE {
      const auto held_back = soft_[m] > free_[m];
      kappa[m] = select(held_back, soft_[m] * pull_[m] - start_[m], zero);
      const auto falls = kappa[m] < -exact;
      let_go[m] =
          select(falls, kappa_[m] / select(falls, kappa_[m] - kappa[m], one), constant<S>(2));
      reach = min(reach, let_go[m]);
    });
    const auto blocked = reach < one;
    const auto changes = active_;
    next_torque_ = torque_ + reach * (next_torque_ - torque_);
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      Row& r = row_[k];
      r.multiplier =
          select(changes, r.multiplier + reach * (next_[k] - r.multiplier), r.multiplier);
      r = choose(changes & blocked & !(ratio[k] > reach), Row{}, r);
    });
    const S moved = abs(next_torque_ - torque_);
    const auto near = moved <= constant<S>(kIsDouble<S> ? 1e-5 : 1e-3);
    const auto over = next_torque_ > constant<S>(1.0 + kExact);
    torque_ =
        select(active_, select(over, constant<S>(0.5) * (torque_ + one), next_torque_), torque_);
    auto settled = near & !blocked;
    for_each_of<kMembers>([&](std::size_t m) PLASTICA_ALWAYS_INLINE {
      const auto below = (free_[m] > zero) & (point_[m] < zero) & !blocked;
      const auto comes = blocked & !(let_go[m] > reach);
      const S now = kappa_[m] + reach * (kappa[m] - kappa_[m]);
      kappa_[m] = select(changes, select(comes, zero, now), kappa_[m]);
      free_[m] = select(changes & below, zero, select(changes & comes, soft_[m], free_[m]));
      settled = settled & !below;
    });
    const auto added = put_furthest(next_torque_, changes & !blocked);
    active_ = active_ & !(settled & !added);
  }

  /// Where a piece says what another one says already, the one that came last says it better: the
  /// other is the one to leave. It hands on its multiplier.
  void replace() {
    const auto spare = active_ & (spare_[0] | spare_[1] | spare_[2]);
    if (!any(spare)) return;
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S half = constant<S>(0.5);
    Row last;
    for (const Row& r : row_) {
      const auto is = r.fresh > half;
      last.x = select(is, r.x, last.x);
      last.y = select(is, r.y, last.y);
      last.on = select(is, r.on, last.on);
      last.pull = select(is, r.pull, last.pull);
    }
    std::array<S, kSlots> alike;
    S most = zero;
    for (std::size_t k = 0; k < kSlots; ++k) {
      const Row& r = row_[k];
      const auto other = (r.on > half) & (r.fresh < half);
      const S whole = select(other, product(r, r), one);
      const S shared = product(r, last);
      alike[k] = select(other, shared * shared / whole, zero);
      most = max(most, alike[k]);
    }
    auto known = spare & (most > zero);
    S inherits = zero;
    for (std::size_t k = 0; k < kSlots; ++k) {
      const auto leaves = known & (alike[k] >= most);
      inherits = select(leaves, row_[k].multiplier, inherits);
      known = known & !leaves;
      spare_[k] = (spare_[k] & !(spare & (most > zero))) | leaves;
    }
    for (Row& r : row_) {
      const auto heir = spare & (most > zero) & (r.fresh > half);
      r.multiplier = select(heir, inherits, r.multiplier);
      r.fresh = select(heir, zero, r.fresh);
    }
  }

  /// `a` where the mask holds, else `b`.
  static Row choose(const mask_t<S>& mask, const Row& a, const Row& b) {
    Row r;
    r.x = select(mask, a.x, b.x);
    r.y = select(mask, a.y, b.y);
    r.on = select(mask, a.on, b.on);
    r.tau_squared = select(mask, a.tau_squared, b.tau_squared);
    r.number = select(mask, a.number, b.number);
    r.multiplier = select(mask, a.multiplier, b.multiplier);
    r.fresh = select(mask, a.fresh, b.fresh);
    return r;
  }

  /// Lets the piece that the point is furthest beyond hold, if it does not yet.
  /// @return where there was one
  mask_t<S> put_furthest(const S& torque, const mask_t<S>& where) {
    const S square = torque * torque;
    const auto value = [&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      const S stress = point_[2] + gauge_.xi[k] * point_[0] + gauge_.eta[k] * point_[1];
      return S(stress * stress + gauge_.tau_squared[k] * square);
    };
    S largest = value(0);
    for (std::size_t k = 1; k < K; ++k) largest = max(largest, value(k));
    const auto beyond = where & (largest > constant<S>(1.0 + 2.0 * kExact));
    if (!any(beyond)) return beyond;
    S number = constant<S>(-1);
    // Of equals the first: it has the largest shear stress.
    for (std::size_t k = K; k-- > 0;) {
      number = select(value(k) >= largest, constant<S>(static_cast<double>(k)), number);
    }
    auto left = beyond;
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      left = left & ((row_[k].number < number) | (row_[k].number > number));
    });
    S ways = select(torque > constant<S>(0), constant<S>(1), constant<S>(0));
    for (const S& c : free_) ways += select(c > constant<S>(0), constant<S>(1), constant<S>(0));
    const S room = min(ways, constant<S>(kSlots)) - constant<S>(0.5);
    const auto full = left & (row_[0].on + row_[1].on + row_[2].on > room);
    if (any(full)) {
      const S least = min(row_[0].multiplier, min(row_[1].multiplier, row_[2].multiplier));
      auto out = full;
      for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
        const auto goes = out & !(row_[k].multiplier > least);
        row_[k] = choose(goes, Row{}, row_[k]);
        out = out & !goes;
      });
    }
    Row piece;
    piece.x = pick(gauge_.xi, number);
    piece.y = pick(gauge_.eta, number);
    piece.tau_squared = pick(gauge_.tau_squared, number);
    piece.number = number;
    piece.on = piece.fresh = constant<S>(1);
    for_each_of<kSlots>([&](std::size_t k) PLASTICA_ALWAYS_INLINE {
      Row& r = row_[k];
      const auto here = left & (r.on < constant<S>(0.5));
      r.fresh = select(beyond, constant<S>(0), r.fresh);
      r = choose(here, piece, r);
      left = left & !here;
    });
    holds_ = holds_ & !left;  // no slot is free
    active_ = active_ & !left;
    return beyond;
  }

  const Gauge& gauge_;
  const SectionForce<S>& target_;
  mask_t<S> active_, holds_;
  std::array<Row, kSlots> row_{};
  S torque_, next_torque_, soft_torsion_;
  SectionForce<S> weight_;  ///< 1/c
  std::array<S, kMembers> start_, soft_, free_, point_, pull_{}, kappa_{};
  Vec<S, kSlots> next_;                    ///< multipliers
  std::array<mask_t<S>, kSlots> spare_{};  ///< whether a row depends on those before it
  Vec<S, kSlots> inverse_;
  S l10_, l20_, l21_;
};

}  // namespace plastica::law::detail
