#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/law/gauge.hpp"
#include "plastica/law/section_response.hpp"

namespace plastica::law {

namespace detail {

/// A symmetric positive definite matrix, given by its lower half, as L D L^T.
template <class S, std::size_t N>
class Factored {
 public:
  explicit Factored(const Mat<S, N, N>& a) : l_(a) {
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const S ljk = l_(j, k);
        for (std::size_t i = j; i < N; ++i) l_(i, j) -= l_(i, k) * ljk * diagonal_[k];
      }
      diagonal_[j] = l_(j, j);
      inverse_[j] = constant<S>(1) / l_(j, j);
      for (std::size_t i = j + 1; i < N; ++i) l_(i, j) *= inverse_[j];
    }
  }

  Vec<S, N> solve(Vec<S, N> b) const {
    for (std::size_t i = 1; i < N; ++i) {
      for (std::size_t k = 0; k < i; ++k) b[i] -= l_(i, k) * b[k];
    }
    for (std::size_t i = 0; i < N; ++i) b[i] *= inverse_[i];
    for (std::size_t i = N; i-- > 0;) {
      for (std::size_t k = i + 1; k < N; ++k) b[i] -= l_(k, i) * b[k];
    }
    return b;
  }

 private:
  Mat<S, N, N> l_;
  std::array<S, N> diagonal_{}, inverse_{};
};

/// Projects in the orthant by interior points (Mehrotra, SIAM J. Optim. 2, 1992, 575): without
/// knowing which constraints will hold. Corners, edges and axes need no case of their own, a trial
/// of any size starts from the same point, and all lanes do the same.
///
/// Unknowns: u, multipliers nu_k of f_k - 1/2 + s_k = 0 with slacks s_k > 0, multipliers kappa_i of
/// u_i >= 0; t has no bound, as phi is smooth in it. Optimality:
///   w (u - target) + sum nu_k grad f_k - kappa = 0,  nu_k s_k = 0,  kappa_i u_i = 0.
/// The weights w = 1/c are scaled so that the multipliers are about 1 however far the target.
template <class Gauge>
class InteriorPoint {
 public:
  using S = typename Gauge::Scalar;

  /// @param overshoot  phi(target) - 1, > 0 where the mask holds
  InteriorPoint(const Gauge& gauge, const SectionForce<S>& compliance,
                const SectionForce<S>& target, const S& overshoot, const mask_t<S>& mask)
      : gauge_(gauge), target_(target) {
    const S one = constant<S>(1);
    const S inverse_size = one / (one + overshoot);
    soft_ = constant<S>(kDouble ? 1e-9 : 1e-4) * min(one, overshoot);
    S largest = compliance[0];
    for (std::size_t i = 1; i < kSectionAxes; ++i) largest = max(largest, compliance[i]);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      weight_[i] = largest / (compliance[i] * overshoot);
      // Well inside: the gauge of the second part is below 0.2.
      const bool present = !(Gauge::kRound && i == kBendingY);
      u_[i] = constant<S>(0.7) * target[i] * inverse_size + constant<S>(present ? 0.05 : 0.0);
    }
    free_weight_ = weight_;
    for (std::size_t b = 0; b < kBounds; ++b) {
      const std::size_t i = kBoundAxis[b];
      // What the target lacks stays away. As an unknown its bound could only just hold, which the
      // method is slow with: it is held by a large weight instead, out of the way of the others.
      const auto lacks = !(target[i] > zero());
      const S tiny = constant<S>(1e-20);
      weight_[i] = select(lacks, constant<S>(1e30), weight_[i]);
      u_[i] = select(lacks, tiny, u_[i]);
      target_[i] = select(lacks, tiny, target[i]);
      slack_[kPieces + b] = u_[i];
      multiplier_[kPieces + b] = select(lacks, tiny, constant<S>(0.1));
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      slack_[k] = constant<S>(0.5) - gauge_.piece(k, u_).value;
      multiplier_[k] = constant<S>(1.0 / kPieces);
    }
    iterate(mask);
  }

  /// The projected point, with the slope of the constraints that hold.
  Projection<S> result() {
    Projection<S> now;
    now.point = last_newton_step();
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      // Where a bound only just holds, the rest of the barrier would show; the exact solution is
      // between 0 and the target.
      now.point[i] = max(min(now.point[i], target_[i]), zero());
    }
    // On the surface to rounding: what is left of the slack goes along the radius.
    now.point = (constant<S>(1) / orthant_gauge(gauge_, now.point)) * now.point;
    const Factored<S, kSectionAxes> matrix(assemble(true));
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      SectionForce<S> column;
      // Nothing else sees a component that is absent: all are even in it.
      column[j] = select(absent(j), zero(), weight_[j]);
      column = matrix.solve(column);
      for (std::size_t i = 0; i < kSectionAxes; ++i) now.slope(i, j) = column[i];
    }
    for (const std::size_t i : kBoundAxis) {
      S pull = zero();
      for (std::size_t k = 0; k < kPieces; ++k) pull += multiplier_[k] * gradient_[k][i];
      // A kink keeps it away, a smooth surface lets it come in.
      const S gives = free_weight_[i] / (free_weight_[i] + bent_[i]);
      const auto kink = pull > constant<S>(kDouble ? 1e-8 : 1e-4);
      now.slope(i, i) = select(absent(i), select(kink, zero(), gives), now.slope(i, i));
      now.point[i] = select(absent(i), zero(), now.point[i]);
    }
    return now;
  }

 private:
  static constexpr std::size_t kPieces = Gauge::kPieces;
  /// A round section has only the resultant moment.
  static constexpr std::size_t kBounds = Gauge::kRound ? 2 : 3;
  static constexpr auto kBoundAxis = [] {
    std::array<std::size_t, kBounds> axis{kBendingX, kAxial};
    if constexpr (kBounds == 3) axis[2] = kBendingY;
    return axis;
  }();
  static constexpr std::size_t kPairs = kPieces + kBounds;  ///< of slack and multiplier
  static constexpr bool kDouble = sizeof(real_t<S>) == 8;
  static constexpr int kMostIterations = 30;

  struct Step {
    SectionForce<S> u;
    std::array<S, kPairs> slack{}, multiplier{};
  };

  static S zero() { return constant<S>(0); }
  mask_t<S> absent(std::size_t i) const { return weight_[i] >= constant<S>(1e30); }

  /// The matrix w + kappa/u + sum nu_k (Hessian + gradient gradient^T/s_k) of the current point,
  /// its lower half; keeps what the steps from here need.
  ///
  /// Stiffer constraints than 1e9 would lose the weights beside them, so slacks are softened to at
  /// least 1e-9 of their multiplier: steps become inexact, residuals stay true.
  /// @param decided  takes each constraint as holding or not, by which of s and nu is larger
  SectionTangent<S> assemble(bool decided) {
    const S one = constant<S>(1);
    const S hardest = one / soft_;
    for (std::size_t k = 0; k < kPairs; ++k) {
      inverse_slack_[k] = one / slack_[k];
      inverse_multiplier_[k] = one / multiplier_[k];
      softened_[k] = min(inverse_slack_[k], hardest * inverse_multiplier_[k]);
      stiffness_[k] = multiplier_[k] * softened_[k];
      if (decided) stiffness_[k] = select(multiplier_[k] > slack_[k], stiffness_[k], zero());
    }
    SectionTangent<S> matrix;
    bent_ = {};
    for (std::size_t i = 0; i < kSectionAxes; ++i) matrix(i, i) = weight_[i];
    for (std::size_t b = 0; b < kBounds; ++b) {
      matrix(kBoundAxis[b], kBoundAxis[b]) += stiffness_[kPieces + b];
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      const GaugePiece<S> f = gauge_.piece(k, u_);
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        const S pull = stiffness_[k] * f.gradient[i];
        for (std::size_t j = 0; j <= i; ++j) {
          matrix(i, j) += multiplier_[k] * f.hessian(i, j) + pull * f.gradient[j];
        }
        bent_[i] += multiplier_[k] * f.hessian(i, i);
      }
      excess_[k] = f.value - constant<S>(0.5);
      gradient_[k] = f.gradient;
    }
    return matrix;
  }

  /// Newton step towards products `centre` of slacks and multipliers, less the part `correction` of
  /// those of the step `by`.
  ///
  /// With ~ for softened slacks: Delta nu = (centre + nu (f - 1/2 + grad f Delta u))/s~, and for
  /// bounds, f - 1/2 = -u.
  Step newton(const Factored<S, kSectionAxes>& matrix, const S& centre, const Step& by,
              const S& correction) const {
    const auto rise = [&](std::size_t k, const S& excess) {
      return (centre - correction * by.slack[k] * by.multiplier[k] + multiplier_[k] * excess) *
             softened_[k];
    };
    Step step;
    SectionForce<S> right;
    for (std::size_t i = 0; i < kSectionAxes; ++i) right[i] = weight_[i] * (target_[i] - u_[i]);
    for (std::size_t b = 0; b < kBounds; ++b) {
      const std::size_t k = kPieces + b;
      const std::size_t i = kBoundAxis[b];
      step.multiplier[k] = select(absent(i), zero(), rise(k, -u_[i]));
      step.slack[k] = u_[i] - slack_[k];
      right[i] += multiplier_[k] + step.multiplier[k];
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      step.multiplier[k] = rise(k, excess_[k]);
      step.slack[k] = -excess_[k] - slack_[k];
      right -= (multiplier_[k] + step.multiplier[k]) * gradient_[k];
    }
    step.u = matrix.solve(right);
    const auto move = [&](std::size_t k, const S& along) {
      step.slack[k] -= along;
      step.multiplier[k] += stiffness_[k] * along;
    };
    for (std::size_t b = 0; b < kBounds; ++b) move(kPieces + b, -step.u[kBoundAxis[b]]);
    for (std::size_t k = 0; k < kPieces; ++k) move(k, dot(gradient_[k], step.u));
    return step;
  }

  /// The longest part of a step that keeps slacks and multipliers positive, at most 1.
  S longest(const Step& step) const {
    S shrinks = constant<S>(1);
    for (std::size_t k = 0; k < kPairs; ++k) {
      shrinks = max(shrinks, max(-step.slack[k] * inverse_slack_[k],
                                 -step.multiplier[k] * inverse_multiplier_[k]));
    }
    return constant<S>(1) / shrinks;
  }

  /// Mean product of slacks and multipliers after a part of a step.
  S gap(const Step& step, const S& length) const {
    S sum = zero();
    for (std::size_t k = 0; k < kPairs; ++k) {
      sum += (slack_[k] + length * step.slack[k]) * (multiplier_[k] + length * step.multiplier[k]);
    }
    return sum * constant<S>(1.0 / kPairs);
  }

  void iterate(mask_t<S> active) {
    const S one = constant<S>(1);
    const S enough = constant<S>(kDouble ? 1e-17 : 1e-7);
    const S stalled = constant<S>(kDouble ? 1e-11 : 1e-5);
    const S settled =
        max(constant<S>(kDouble ? 1e3 : 1e2) * soft_, constant<S>(kDouble ? 1e-15 : 1e-6));
    S now = gap({}, zero());
    for (int iteration = 0; iteration < kMostIterations && any(active); ++iteration) {
      const Factored<S, kSectionAxes> matrix(assemble(false));
      const Step affine = newton(matrix, zero(), {}, zero());
      const S reach = longest(affine);
      const S left = gap(affine, reach) / now;
      const Step step = newton(matrix, now * left * left * left, affine,
                               select(reach > constant<S>(0.5), one, zero()));
      const S length = min(one, constant<S>(0.995) * longest(step));
      S moved = zero();
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        moved = max(moved, abs(length * step.u[i]));
        u_[i] = select(active, u_[i] + length * step.u[i], u_[i]);
      }
      for (std::size_t k = 0; k < kPairs; ++k) {
        slack_[k] = select(active, slack_[k] + length * step.slack[k], slack_[k]);
        multiplier_[k] =
            select(active, multiplier_[k] + length * step.multiplier[k], multiplier_[k]);
      }
      const S after = gap({}, zero());
      // At a corner where many constraints meet their multipliers may wander when all is done.
      const auto stalls = (after < stalled) & (after > constant<S>(0.3) * now);
      active = active & ((after > enough) | (moved > settled)) & !stalls;
      now = after;
    }
  }

  /// One more step, whole and without a centre: it squares the error, and a dual scalar gets the
  /// derivative of the solution from it.
  SectionForce<S> last_newton_step() {
    return u_ + newton(Factored<S, kSectionAxes>(assemble(false)), zero(), {}, zero()).u;
  }

  const Gauge& gauge_;
  SectionForce<S> target_, weight_, u_;
  SectionForce<S> free_weight_;               ///< without what holds absent components
  std::array<S, kPairs> slack_, multiplier_;  ///< of the pieces, then of the bounds
  S soft_;
  // Of the current point, by `assemble`:
  std::array<S, kPairs> inverse_slack_, inverse_multiplier_, softened_, stiffness_;
  std::array<S, kPieces> excess_;  ///< f - 1/2
  std::array<SectionForce<S>, kPieces> gradient_;
  SectionForce<S> bent_;  ///< sum of nu_k times the second derivatives
};

}  // namespace detail
}  // namespace plastica::law
