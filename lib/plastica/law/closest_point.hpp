#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/each_of.hpp"
#include "plastica/base/matrix.hpp"
#include "plastica/law/gauge.hpp"
#include "plastica/law/section_block.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law::detail {

/// Projects, in the orthant, onto any yield surface: sequential quadratic programming with the
/// Hessian of the Lagrangian (Nocedal and Wright, Numerical Optimization, 2006, chapter 18), each
/// program by an active set of its dual (Goldfarb and Idnani, Math. Program. 27, 1983, 1).
///
///   minimize sum w_i (u_i - y_i)^2/2, w = 1/c, subject to phi_k(u) <= 1 and u >= 0.
/// phi_k is convex and homogeneous: with its gradient a at any point, a.u <= 1 touches the surface
/// and cuts off nothing of what is inside. So planes taken anywhere hold together, and multipliers
/// of the last program start the next.
///
/// A step goes to the least energy on the planes of the working set. With its multipliers nu, H = W
/// + sum nu_k f_k''/phi_k and M = H^-1 among the components that are free,
///   r = W (y - u) - A^T nu,  (A M A^T) dnu = A (u + M r) - 1,  step = M (r - A^T dnu).
/// (f'' is phi_k phi_k'' + a a^T. The last term changes nothing along a plane, and with it torsion
/// stands alone in H.) The plane or bound whose multiplier would become negative first leaves, and
/// the program is solved again.
///
/// After a step, components below zero are held there, the point returns to the surface along its
/// radius, and the facet that the step went furthest beyond joins. The point is taken if the energy
/// falls by a fraction of what the program promises, or if the step is less than half of all before
/// it, as Newton's method's are; else half of it is tried. Some small steps are taken untested (a
/// watchdog; Chamberlain and others, Math. Program. Study 16, 1982, 1): edges that bend make tested
/// ones short.
template <class Gauge>
class ClosestPoint {
 public:
  using S = typename Gauge::Scalar;

  /// @param overshoot  phi(target) - 1, > 0 where the mask holds
  ClosestPoint(const Gauge& gauge, const SectionForce<S>& compliance, const SectionForce<S>& target,
               const S& overshoot, const mask_t<S>& mask)
      : gauge_(gauge), target_(target), unfinished_(mask) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S inverse = one / (one + overshoot);
    S reach = zero;
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      weight_[i] = one / compliance[i];
      point_[i] = inverse * target[i];
      reach += weight_[i] * target[i] * point_[i];
      present_[i] = select(target[i] > zero, one, zero);
    });
    free_ = present_;
    const S others = present_[kBendingX] + present_[kBendingY] + present_[kAxial];
    const auto from_afar =
        (overshoot > constant<S>(0.5)) & (present_[kTorsion] > zero) & (others > constant<S>(1.5));
    round_ = select(from_afar, one, zero);
    rounding_ = constant<S>(kExact) * reach;
    settled_ =
        constant<S>(kSettled) * min(one, overshoot) + constant<S>(kExact) * (one + overshoot);
    const Values values = values_at(target);
    working_[0].facet = number_of(values, largest_of(values));
    // The sum of all multipliers if this point were the closest, as a.point = 1.
    working_[0].curving = working_[0].multiplier = reach * overshoot * inverse;
    for (; steps_ < kMaxSteps && any(unfinished_); ++steps_) advance();
    // One more step squares the error, and gives a dual scalar its derivative.
    linearize();
    solve();
  }

  /// Steps taken; of lanes the most.
  int steps() const { return steps_; }
  /// Where the steps ended before the last of them was needed.
  mask_t<S> converged() const { return !unfinished_; }

  /// The projected point, with slope = (M - M A^T (A M A^T)^-1 A M) W.
  Projection<S> result() const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    SectionForce<S> u;
    for_each_of<kSectionAxes>(
        [&](std::size_t i) PLASTICA_ALWAYS_INLINE { u[i] = max(point_[i] + step_[i], zero); });
    const S value = largest_of(values_at(u));
    Projection<S> now;
    now.point = (one / sqrt(value + value)) * u;
    const SectionTangent<S> m = inverse_.full();
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        S left = i == j ? free_[i] * m(i, i) : m(i, j);
        for (std::size_t k = 0; k < used(); ++k) left -= soft_[k][i] * soft_[k][j] * pivot_[k];
        now.slope(i, j) = left * weight_[j];
        now.slope(j, i) = left * weight_[i];
      }
    }
    mask_t<S> absent = present_[kTorsion] < one;
    for (const std::size_t i : kBounded) absent = absent | (present_[i] < one);
    if (any(absent)) let_in_beside(now);
    return now;
  }

 private:
  static constexpr std::size_t kFacets = Gauge::kFacets;
  /// At most as many planes are independent as there are components; one more replaces another.
  static constexpr std::size_t kPlanes = kFacets < 5 ? kFacets : 5;
  /// phi is smooth in torsion; a round section has only the resultant moment.
  static constexpr std::size_t kBounds = Gauge::kRound ? 2 : 3;
  static constexpr auto kBounded = [] {
    std::array<std::size_t, kBounds> axis{kBendingX, kAxial};
    if constexpr (kBounds == 3) axis[2] = kBendingY;
    return axis;
  }();
  static constexpr int kMaxSteps = 100;
  static constexpr int kFirstSteps = 2;
  static constexpr double kSmallStep = 0.3;  ///< of those that are not watched
  static constexpr double kExact = kIsDouble<S> ? 1e-13 : 1e-6;
  static constexpr double kSettled = kIsDouble<S> ? 1e-9 : 1e-5;
  /// The last step but one, over what it leads to.
  static constexpr double kNear = kIsDouble<S> ? 1e-6 : 1e-3;

  /// Planes up to the last one in any lane. (That one facet has one plane a compiler cannot see.)
  std::size_t used() const { return kPlanes == 1 ? 1 : used_; }

  /// A plane of the working set.
  struct Plane {
    S facet{constant<S>(-1)};  ///< its number, -1 where there is none
    S multiplier{};
    S curving{};             ///< the multiplier in H
    SectionForce<S> normal;  ///< a
  };
  using Values = std::array<S, kFacets>;

  Values values_at(const SectionForce<S>& u) const {
    return each_of<kFacets>([&](std::size_t k)
                                PLASTICA_ALWAYS_INLINE -> S { return gauge_.facet(k, u).value; });
  }
  /// In four rows, which do not wait for each other.
  static S largest_of(const Values& values) {
    constexpr std::size_t kRows = kFacets < 4 ? kFacets : 4;
    std::array<S, kRows> most;
    for_each_of<kRows>([&](std::size_t row) PLASTICA_ALWAYS_INLINE {
      most[row] = values[row];
      for (std::size_t k = row + kRows; k < kFacets; k += kRows) {
        most[row] = max(most[row], values[k]);
      }
    });
    S largest = most[0];
    for (std::size_t row = 1; row < kRows; ++row) largest = max(largest, most[row]);
    return largest;
  }
  /// Of equals the first: it has the largest shear stress.
  static S number_of(const Values& values, const S& largest) {
    S number = constant<S>(0);
    for (std::size_t k = kFacets; k-- > 0;) {
      number = select(values[k] >= largest, constant<S>(static_cast<double>(k)), number);
    }
    return number;
  }

  /// Normals, and the Hessian of the Lagrangian, at the point.
  void linearize() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    // Off zero by what is lost beside any force: a facet that nothing bears on has a normal there.
    SectionForce<S> u;
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      u[i] = max(point_[i], constant<S>(1e-15) * present_[i]);
    });
    const S round = round_now();
    hessian_ = SectionBlock<S>::diagonal(weight_);
    for (std::size_t k = 0; k < used(); ++k) {
      Plane& plane = working_[k];
      const GaugeFacet<S> f = gauge_.facet_at(plane.facet, u);
      const auto there = plane.facet >= zero;
      const S inverse = select(there, one / sqrt(f.value + f.value + constant<S>(1e-35)), zero);
      plane.normal = inverse * f.gradient;
      const S curving = plane.curving * min(inverse, constant<S>(4));
      hessian_.add(curving * (one - round), f.hessian);
      for_each_of<kSectionAxes>([&](std::size_t i)
                                    PLASTICA_ALWAYS_INLINE { hessian_.at[i] += curving * round; });
    }
  }

  /// All steps but the last four of sixteen: so tested steps come first.
  bool watched() const { return steps_ % 16 < 12; }
  /// From far beyond with torsion, the first steps take the surface for a ball: a facet may leave
  /// out torsion, or be flat in a moment, and the step along it would go far off.
  S round_now() const { return steps_ < kFirstSteps ? round_ : constant<S>(0); }

  /// The step to the working set, and its multipliers.
  void solve() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    inverse_ = hessian_.inverse(free_);
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      residual_[i] = weight_[i] * (target_[i] - point_[i]);
    });
    for (std::size_t k = 0; k < used(); ++k) {
      residual_ -= working_[k].multiplier * working_[k].normal;
    }
    // What is held goes to zero, if it is not there yet.
    SectionForce<S> off;
    for (const std::size_t i : kBounded) off[i] = (present_[i] - free_[i]) * point_[i];
    step_ = inverse_.times(of_free(residual_ + hessian_.times(off)));
    // A M A^T = l D l^T.
    std::array<S, kPlanes> beyond;
    std::array<std::array<S, kPlanes>, kPlanes> lower;
    for (std::size_t k = 0; k < used(); ++k) {
      const auto there = working_[k].facet >= zero;
      const SectionForce<S> normal = of_free(working_[k].normal);
      soft_[k] = inverse_.times(normal);
      const S whole = dot(normal, soft_[k]);
      S left = whole;
      beyond[k] = dot(normal, point_ + step_) - select(there, one, zero);
      for (std::size_t j = 0; j < k; ++j) {
        const S shared = dot(normal, soft_[j]);
        lower[k][j] = shared * pivot_[j];
        left -= shared * lower[k][j];
        beyond[k] -= lower[k][j] * beyond[j];
      }
      for (std::size_t j = 0; j < k; ++j) soft_[k] -= lower[k][j] * soft_[j];
      // A plane that others give already is a little soft: multipliers stay finite, and of those
      // that are too many one becomes negative.
      left = max(left, constant<S>(kExact) * whole + constant<S>(1e-30));
      pivot_[k] = select(there, one / left, zero);
    }
    for (std::size_t k = used(); k-- > 0;) {
      const S along = beyond[k] * pivot_[k];
      step_ -= along * soft_[k];
      rise_[k] = along;
      for (std::size_t j = k + 1; j < used(); ++j) rise_[k] -= lower[j][k] * rise_[j];
    }
    for (const std::size_t i : kBounded) step_[i] = select(held(i), -point_[i], step_[i]);
  }

  mask_t<S> held(std::size_t i) const { return present_[i] > free_[i]; }
  SectionForce<S> of_free(const SectionForce<S>& a) const {
    return {each_of<kSectionAxes>([&](std::size_t i)
                                      PLASTICA_ALWAYS_INLINE -> S { return free_[i] * a[i]; })};
  }

  /// Solves, and lets go what would pull, one at a time: by the part of the way to the new
  /// multipliers at which the first of them is zero.
  void solve_program() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const auto part = [&](const S& from, const S& to) {
      const auto falls = to < zero;
      return select(falls, from / select(falls, from - to, one), constant<S>(2));
    };
    for (auto open = unfinished_; any(open);) {
      const SectionForce<S> done = step_;
      solve();
      step_ = select(open, step_, done);  // not of lanes whose multipliers have been taken
      S length = one;
      std::array<S, kPlanes> ends;
      for (std::size_t k = 0; k < used(); ++k) {
        ends[k] = part(working_[k].multiplier, working_[k].multiplier + rise_[k]);
        length = min(length, ends[k]);
      }
      SectionForce<S> press, bound_ends;
      const SectionForce<S> along = hessian_.times(step_);
      for (const std::size_t i : kBounded) {
        if (!any(held(i))) continue;
        S sum = along[i] - residual_[i];
        for (std::size_t k = 0; k < used(); ++k) sum += rise_[k] * working_[k].normal[i];
        press[i] = select(held(i), sum, zero);
        bound_ends[i] = part(press_[i], press[i]);
        length = min(length, bound_ends[i]);
      }
      auto leaves = open & (length < one);
      const auto again = leaves;
      for (std::size_t k = 0; k < used(); ++k) {
        Plane& plane = working_[k];
        const auto out = leaves & !(ends[k] > length);
        leaves = leaves & !out;
        plane.multiplier = select(open, plane.multiplier + length * rise_[k], plane.multiplier);
        plane.multiplier = select(out, zero, plane.multiplier);
        plane.facet = select(out, constant<S>(-1), plane.facet);
        plane.normal = select(out, SectionForce<S>{}, plane.normal);
      }
      for (const std::size_t i : kBounded) {
        if (!any(held(i))) continue;
        const auto out = leaves & held(i) & !(bound_ends[i] > length);
        leaves = leaves & !out;
        press_[i] = select(open, press_[i] + length * (press[i] - press_[i]), press_[i]);
        press_[i] = select(out, zero, press_[i]);
        free_[i] = select(out, present_[i], free_[i]);
      }
      open = again;
    }
  }

  /// A step, and what holds after it.
  void advance() {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S half = constant<S>(0.5);
    linearize();
    solve_program();
    auto below = unfinished_ & (zero > one);
    for (const std::size_t i : kBounded) {
      const auto under = unfinished_ & (free_[i] > zero) & (point_[i] + step_[i] < zero);
      free_[i] = select(under, zero, free_[i]);
      below = below | under;
    }
    S left = zero;
    S longest = constant<S>(1e-30);
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      longest = max(longest, abs(step_[i]));
      left = max(left, abs(step_[i]) - constant<S>(kNear) * (point_[i] + step_[i]));
    });
    const S length = length_ * min(one, one / longest);
    SectionForce<S> trial;
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      trial[i] = max(point_[i] + length * step_[i], zero);
    });
    const Values values = values_at(trial);
    const S value = largest_of(values);
    trial = (one / sqrt(value + value)) * trial;
    S falls = zero;
    S size = zero;
    for_each_of<kSectionAxes>([&](std::size_t i) PLASTICA_ALWAYS_INLINE {
      const S middle = half * (trial[i] + point_[i]);
      falls += weight_[i] * (trial[i] - point_[i]) * (target_[i] - middle);
      size += weight_[i] * step_[i] * step_[i];
    });
    const auto moves = unfinished_ & ((falls + rounding_ > constant<S>(1e-4) * length * size) |
                                      (size < constant<S>(0.25) * smallest_) |
                                      (longest < constant<S>(watched() ? 0.0 : kSmallStep)));
    smallest_ = select(moves & !(round_now() > zero), min(smallest_, size), smallest_);
    length_ = select(moves, one, half * length_);
    point_ = select(moves, trial, point_);
    for (std::size_t k = 0; k < used(); ++k) {
      working_[k].curving = select(moves, working_[k].multiplier, working_[k].curving);
    }
    mask_t<S> joins = unfinished_ & (value > constant<S>(0.5 + kExact));
    if (any(joins)) join(number_of(values, value), joins);
    unfinished_ = unfinished_ & ((left > settled_) | below | joins | (round_now() > zero));
  }

  /// Puts a facet into the working set, where it is not in it.
  /// @param where  in: where it is to join; out: where it does
  void join(const S& facet, mask_t<S>& where) {
    for (std::size_t k = 0; k < used(); ++k) {
      where = where & ((working_[k].facet < facet) | (working_[k].facet > facet));
    }
    auto open = where;
    for (std::size_t k = 0; k < kPlanes && any(open); ++k) {
      const auto here = open & (working_[k].facet < constant<S>(0));
      working_[k].facet = select(here, facet, working_[k].facet);
      working_[k].curving = select(here, constant<S>(0), working_[k].curving);
      open = open & !here;
      if (k >= used_) used_ = k + 1;
    }
  }

  /// What the target lacks a kink keeps away, and a smooth surface lets come in against its
  /// curvature. A kink may be of any facet that the point is on.
  void let_in_beside(Projection<S>& now) const {
    const S zero = constant<S>(0);
    const SectionTangent<S> bent = hessian_.full();
    SectionForce<S> gradient;
    for (std::size_t k = 0; k < kFacets; ++k) {
      const GaugeFacet<S> f = gauge_.facet(k, now.point);
      const auto holds = f.value > constant<S>(0.5 - (kIsDouble<S> ? 1e-9 : 1e-4));
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        gradient[i] = max(gradient[i], select(holds, f.gradient[i], zero));
      }
    }
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (Gauge::kRound && i == kBendingY) continue;
      const auto kink = gradient[i] > constant<S>(kIsDouble<S> ? 1e-8 : 1e-4);
      const S alone = select(kink, zero, weight_[i] / bent(i, i));
      now.slope(i, i) = select(present_[i] > zero, now.slope(i, i), alone);
    }
  }

  const Gauge& gauge_;
  const SectionForce<S>& target_;
  mask_t<S> unfinished_;
  int steps_ = 0;
  SectionForce<S> weight_, point_, step_, residual_;
  SectionForce<S> present_;  ///< 1 of what the target has
  SectionForce<S> free_;     ///< 1 of what is not held at zero, either
  SectionForce<S> press_;    ///< multipliers of the bounds
  std::array<Plane, kPlanes> working_{};
  std::size_t used_ = 1;  ///< of the planes, in any lane
  S rounding_, settled_;
  S round_;  ///< 1 where the first steps take the surface for a ball
  S length_{constant<S>(1)}, smallest_{constant<S>(1e30)};
  // Of the current point, by `linearize` and `solve`:
  SectionBlock<S> hessian_, inverse_;            ///< H, M
  std::array<SectionForce<S>, kPlanes> soft_{};  ///< M A^T l^-T
  std::array<S, kPlanes> pivot_{}, rise_{};      ///< 1/D; dnu
};

}  // namespace plastica::law::detail
