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

 public:
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
  static constexpr std::size_t kPieces = Gauge::kPieces;

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
      u_[i] = constant<S>(0.7) * target[i] * inverse_size + constant<S>(present(i) ? 0.05 : 0.0);
      kappa_[i] = bounded(i) ? constant<S>(0.1) : constant<S>(0);
      free_weight_[i] = weight_[i];
      if (!bounded(i)) continue;
      // What the target lacks stays away. As an unknown its bound could only just hold, which the
      // method is slow with: it is held by a large weight instead, out of the way of the others.
      const auto lacks = !(target[i] > constant<S>(0));
      const S tiny = constant<S>(1e-20);
      weight_[i] = select(lacks, constant<S>(1e30), weight_[i]);
      u_[i] = select(lacks, tiny, u_[i]);
      kappa_[i] = select(lacks, tiny, kappa_[i]);
      target_[i] = select(lacks, tiny, target[i]);
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      slack_[k] = constant<S>(0.5) - gauge_.piece(k, u_).value;
      nu_[k] = constant<S>(1.0 / kPieces);
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
      now.point[i] = max(min(now.point[i], target_[i]), constant<S>(0));
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
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (!bounded(i)) continue;
      S pull = zero();
      for (std::size_t k = 0; k < kPieces; ++k) pull += nu_[k] * gradient_[k][i];
      // A kink keeps it away, a smooth surface lets it come in.
      const S gives = free_weight_[i] / (free_weight_[i] + bent_[i]);
      const auto kink = pull > constant<S>(kDouble ? 1e-8 : 1e-4);
      now.slope(i, i) = select(absent(i), select(kink, zero(), gives), now.slope(i, i));
      now.point[i] = select(absent(i), zero(), now.point[i]);
    }
    return now;
  }

 private:
  /// A round section has only the resultant moment.
  static constexpr bool present(std::size_t i) { return !(Gauge::kRound && i == kBendingY); }
  static constexpr bool bounded(std::size_t i) { return i != kTorsion && present(i); }
  mask_t<S> absent(std::size_t i) const { return weight_[i] >= constant<S>(1e30); }
  static constexpr bool kDouble = sizeof(real_t<S>) == 8;
  static constexpr int kMostIterations = 30;

  /// The matrix w + kappa/u + sum nu_k (Hessian + gradient gradient^T/s_k) of the current point;
  /// keeps values and gradients of the pieces.
  /// @param decided  takes each constraint as holding or not, by which of s and nu is larger
  SectionTangent<S> assemble(bool decided) {
    SectionTangent<S> matrix;
    bent_ = {};
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      matrix(i, i) = weight_[i];
      if (bounded(i)) matrix(i, i) += share(kappa_[i], u_[i], decided);
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      const GaugePiece<S> f = gauge_.piece(k, u_);
      const S stiff = share(nu_[k], slack_[k], decided);
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        const S pull = stiff * f.gradient[i];
        bent_[i] += nu_[k] * f.hessian(i, i);
        // `Factored` reads the lower half.
        for (std::size_t j = 0; j <= i; ++j) {
          matrix(i, j) += nu_[k] * f.hessian(i, j) + pull * f.gradient[j];
        }
      }
      excess_[k] = f.value - constant<S>(0.5);
      gradient_[k] = f.gradient;
    }
    return matrix;
  }

  /// A slack for the matrix, which would lose the weights beside a stiffer constraint. It makes the
  /// steps inexact, the residuals stay true.
  S softened(const S& multiplier, const S& slack) const { return max(slack, soft_ * multiplier); }

  S share(const S& multiplier, const S& slack, bool decided) const {
    const S ratio = multiplier / softened(multiplier, slack);
    return decided ? select(multiplier > slack, ratio, constant<S>(0)) : ratio;
  }

  struct Step {
    SectionForce<S> u, kappa;
    std::array<S, kPieces> slack, nu;
  };

  /// Newton step towards products `centre` of multipliers and slacks, less the part `correction` of
  /// those of the step `by`.
  ///
  /// With ~ for softened slacks: Delta nu = (centre + nu (f + grad f Delta u))/s~,
  /// Delta kappa = (centre - kappa (u + Delta u))/u~.
  Step newton(const Factored<S, kSectionAxes>& matrix, const S& centre, const Step& by,
              const S& correction) const {
    const auto wanted = [&](const S& a, const S& b) { return centre - correction * a * b; };
    Step step;
    SectionForce<S> right;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      right[i] = weight_[i] * (target_[i] - u_[i]);
      if (!bounded(i)) continue;
      const S change =
          (wanted(by.kappa[i], by.u[i]) - kappa_[i] * u_[i]) / softened(kappa_[i], u_[i]);
      step.kappa[i] = select(absent(i), zero(), change);
      right[i] += kappa_[i] + step.kappa[i];
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      step.slack[k] = -(excess_[k] + slack_[k]);
      step.nu[k] =
          (wanted(by.nu[k], by.slack[k]) + nu_[k] * excess_[k]) / softened(nu_[k], slack_[k]);
      right -= (nu_[k] + step.nu[k]) * gradient_[k];
    }
    step.u = matrix.solve(right);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (bounded(i)) step.kappa[i] -= share(kappa_[i], u_[i], false) * step.u[i];
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      const S along = dot(gradient_[k], step.u);
      step.slack[k] -= along;
      step.nu[k] += share(nu_[k], slack_[k], false) * along;
    }
    return step;
  }

  static S zero() { return constant<S>(0); }

  /// The longest part of a step that keeps slacks and multipliers positive, at most 1.
  S longest(const Step& step) const {
    S length = constant<S>(1);
    const auto keep = [&](const S& x, const S& dx) {
      const auto falls = dx < zero();
      length = min(length, select(falls, x / select(falls, -dx, constant<S>(1)), length));
    };
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (!bounded(i)) continue;
      keep(u_[i], step.u[i]);
      keep(kappa_[i], step.kappa[i]);
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      keep(slack_[k], step.slack[k]);
      keep(nu_[k], step.nu[k]);
    }
    return length;
  }

  /// Mean product of multipliers and slacks after a part of a step.
  S gap(const Step& step, const S& length) const {
    S sum = zero();
    const auto add = [&](const S& x, const S& y, const S& dx, const S& dy) {
      sum += (x + length * dx) * (y + length * dy);
    };
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      if (bounded(i)) add(u_[i], kappa_[i], step.u[i], step.kappa[i]);
    }
    for (std::size_t k = 0; k < kPieces; ++k) {
      add(slack_[k], nu_[k], step.slack[k], step.nu[k]);
    }
    constexpr int kBounds = Gauge::kRound ? 2 : 3;
    return sum * constant<S>(1.0 / (kPieces + kBounds));
  }

  void iterate(mask_t<S> active) {
    const S one = constant<S>(1);
    const S enough = constant<S>(kDouble ? 1e-17 : 1e-7);
    const S stalled = constant<S>(kDouble ? 1e-11 : 1e-5);
    const S settled =
        max(constant<S>(kDouble ? 1e3 : 1e2) * soft_, constant<S>(kDouble ? 1e-15 : 1e-6));
    for (int iteration = 0; iteration < kMostIterations && any(active); ++iteration) {
      const Factored<S, kSectionAxes> matrix(assemble(false));
      const S now = gap({}, zero());
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
        kappa_[i] = select(active, kappa_[i] + length * step.kappa[i], kappa_[i]);
      }
      for (std::size_t k = 0; k < kPieces; ++k) {
        slack_[k] = select(active, slack_[k] + length * step.slack[k], slack_[k]);
        nu_[k] = select(active, nu_[k] + length * step.nu[k], nu_[k]);
      }
      const S after = gap({}, zero());
      // At a corner where many constraints meet their multipliers may wander when all is done.
      const auto stalls = (after < stalled) & (after > constant<S>(0.3) * now);
      active = active & ((after > enough) | (moved > settled)) & !stalls;
    }
  }

  /// One more step, whole and without a centre: it squares the error, and a dual scalar gets the
  /// derivative of the solution from it.
  SectionForce<S> last_newton_step() {
    return u_ + newton(Factored<S, kSectionAxes>(assemble(false)), zero(), {}, zero()).u;
  }

  const Gauge& gauge_;
  SectionForce<S> target_, weight_, u_, kappa_;
  SectionForce<S> free_weight_;  ///< without what holds absent components
  SectionForce<S> bent_;         ///< sum of nu_k times the second derivatives
  S soft_;
  std::array<S, kPieces> slack_, nu_;
  std::array<S, kPieces> excess_;  ///< f - 1/2
  std::array<SectionForce<S>, kPieces> gradient_;
};

}  // namespace detail
}  // namespace plastica::law
