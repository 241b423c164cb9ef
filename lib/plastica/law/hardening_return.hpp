#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/law/gauge_form.hpp"
#include "plastica/law/project.hpp"
#include "plastica/law/section_response.hpp"
#include "plastica/law/uniaxial.hpp"

/// The return to a yield surface that hardens, see interaction.hpp.
namespace plastica::law {

namespace detail {

/// The return with hardening: p and all that follows from it, with derivatives by z^.
template <class Section>
class HardeningReturn {
 public:
  using S = std::remove_cvref_t<decltype(Section::cap[0])>;
  using Rule = decltype(Section::rule);
  static constexpr std::size_t kBacks = Rule::kBacks;

  HardeningReturn(const Section& law, const typename Section::State& before,
                  const SectionForce<S>& trial, const S& phi, const mask_t<S>& yields)
      : law_(law), before_(before), elastic_(law.elastic), trial_(trial), phi_(phi) {
    solve(yields);
  }

  /// Fills force over caps, its derivative by z^, state and plastic work.
  void finish(SectionForce<S>& z, SectionTangent<S>& slope, typename Section::State& after,
              S& work) const {
    const S one = constant<S>(1);
    const S total = lambda_;  // lambda~
    const S plastic = plastic_area_ * p_;
    const S part = plastic / total;
    const SectionForce<S> cut = trial_ - projected_.point;
    SectionForce<S> flow;  // A cut: normal times lambda~
    SectionForce<S> back;
    for (std::size_t i = 0; i < kSectionAxes; ++i) flow[i] = elastic_[i] * cut[i];
    const S length = total / elastic_area_;
    const S square = dot(flow, cut) / (total * length);
    work = plastic_area_ * law_.rule.radius_integral(before_.equivalent, p_);
    for (std::size_t k = 0; k < kBacks; ++k) {
      after.back[k] = before_.back[k] + (shift_[k].value / length) * cut;
      back += after.back[k];
      const S decayed = decayed_at_end(k);
      const S shifted = law_.rule.source_integral(k, before_.equivalent, p_, decayed) +
                        along_[k] * (decayed - p_);
      work += plastic_area_ * (dot(before_.back[k], flow) / total * p_ + square * shifted);
    }
    z = projected_.point + back;
    after.equivalent = before_.equivalent + p_;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      const S d = law_.per_force[i] * part * cut[i];
      after.plastic[i] = before_.plastic[i] + d;
      after.accumulated[i] = before_.accumulated[i] + abs(d);
    }

    // T = A_p p + A_e sum shifts depends on p, by itself and by the radius, and on z^ by the
    // direction of z: d p = (d lambda~ at fixed p - d T)/(T' - d lambda~/d p).
    const SectionForce<S> d_plastic = through_point(plastic_by_point_);
    const SectionForce<S> d_needed = through_point(needed_by_point_);
    SectionForce<S> d_lambda;
    for (std::size_t i = 0; i < kSectionAxes; ++i) d_lambda[i] = elastic_[i] * by_radius_[i];
    const SectionForce<S> d_p =
        (one / (needed_slope_ - lambda_by_radius_ * level_.slope)) * (d_lambda - d_needed);
    const SectionForce<S> d_part =
        (one / total) *
        (p_ * d_plastic + (plastic_area_ + p_ * plastic_by_radius_ * level_.slope) * d_p -
         part * (d_needed + needed_slope_ * d_p));
    slope = identity<S, kSectionAxes>() -
            part * (identity<S, kSectionAxes>() - projected_.slope -
                    outer(by_radius_, level_.slope * d_p)) -
            outer(cut, d_part);
  }

 private:
  static constexpr int kMaxSteps = 40;

  S decayed_at_end(std::size_t k) const {
    return back_flow(law_.rule, k, before_.equivalent, p_).decayed;
  }

  /// Projects on the surface of radius level(p); lambda~ and the derivatives by the radius follow
  /// from the homogeneity of both in (z^, radius).
  void project_at(const S& p, const mask_t<S>& mask) {
    const S one = constant<S>(1);
    level_ = law_.rule.radius(before_.equivalent, p);
    const S inverse = one / level_.value;
    const S overshoot = select(mask, phi_ * inverse - one, one);
    projected_ = project(law_.gauge, law_.compliance, inverse * trial_, overshoot, mask);
    projected_.point = level_.value * projected_.point;
    by_radius_ = inverse * (projected_.point - projected_.slope * trial_);
    lambda_ = constant<S>(0);
    S by_trial = constant<S>(0);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      lambda_ += elastic_[i] * (trial_[i] - projected_.point[i]) * projected_.point[i] * inverse;
      by_trial += elastic_[i] * trial_[i] * by_radius_[i];
    }
    lambda_by_radius_ = (lambda_ - by_trial) * inverse;
    find_needed(p, inverse);
  }

  /// T = A_p p + A_e sum shifts in the direction of the projected point, with its derivative by p,
  /// the point's and the radius's among them, and by the point alone.
  void find_needed(const S& p, const S& inverse) {
    const S two = constant<S>(2);
    const SectionForce<S>& point = projected_.point;
    const S square = inverse * inverse;
    SectionForce<S> energy, work;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      energy[i] = elastic_[i] * point[i];
      work[i] = law_.area[i] * point[i];
    }
    const S twice_energy = dot(energy, point);
    elastic_area_ = twice_energy * square;
    plastic_area_ = dot(work, point) * square;
    plastic_by_point_ = (two * square) * work;
    plastic_by_radius_ = dot(plastic_by_point_, by_radius_) - two * plastic_area_ * inverse;
    needed_ = plastic_area_ * p;
    needed_by_point_ = p * plastic_by_point_;
    S by_radius = p * plastic_by_radius_;
    needed_slope_ = plastic_area_;
    const SectionForce<S> elastic_by_point = (two * square) * energy;
    const S elastic_by_radius = dot(elastic_by_point, by_radius_) - two * elastic_area_ * inverse;
    for (std::size_t k = 0; k < kBacks; ++k) {
      along_[k] = dot(before_.back[k], energy) / twice_energy * level_.value;
      shift_[k] = law_.rule.shift(k, before_.equivalent,
                                  law_.rule.drive(k, before_.equivalent, along_[k]), p);
      needed_ += elastic_area_ * shift_[k].value;
      needed_slope_ += elastic_area_ * shift_[k].slope;
      needed_by_point_ += shift_[k].value * elastic_by_point;
      by_radius += shift_[k].value * elastic_by_radius;
      if constexpr (Rule::kRecovers) {
        SectionForce<S> along_by_point;
        for (std::size_t i = 0; i < kSectionAxes; ++i) {
          along_by_point[i] =
              (level_.value * elastic_[i] * before_.back[k][i] - two * along_[k] * energy[i]) /
              twice_energy;
        }
        const S by_along = -elastic_area_ * law_.rule.recovery(k) *
                           back_flow(law_.rule, k, before_.equivalent, p).decayed;
        needed_by_point_ += by_along * along_by_point;
        by_radius += by_along * (dot(along_by_point, by_radius_) + along_[k] * inverse);
      }
    }
    needed_slope_ += by_radius * level_.slope;
  }

  /// The derivative by z^ of what depends on it by the projected point.
  SectionForce<S> through_point(const SectionForce<S>& by_point) const {
    SectionForce<S> derivative;
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        derivative[j] += by_point[i] * projected_.slope(i, j);
      }
    }
    return derivative;
  }

  /// Newton for lambda~(level(p)) = A_p p + A_e sum shifts(p), inside of a bracket.
  void solve(const mask_t<S>& yields) {
    const S zero = constant<S>(0);
    S low = zero;
    // lambda~ is at most the support function of the surface at A z^, as at radius zero; and no
    // shift undoes more than the back stress that there is. A gauge is convex and 1 at each axis'
    // cap, so that the squares of a point of the surface sum up to a quarter at least.
    S most = zero;
    S squares = zero;
    S least_area = law_.area[0];
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      squares += elastic_[i] * trial_[i] * trial_[i];
      S reach = abs(trial_[i]);
      for (std::size_t k = 0; k < kBacks; ++k) reach += abs(before_.back[k][i]);
      most += elastic_[i] * reach;
      least_area = min(least_area, law_.area[i]);
    }
    S high = select(yields, constant<S>(4) * most / least_area, zero);
    const S begins = law_.rule.radius(before_.equivalent, zero).value;
    p_ = select(yields, first_flow(law_.rule, S(phi_ / begins - constant<S>(1)), high), zero);
    auto active = yields;
    constexpr bool kDouble = sizeof(real_t<S>) == 8;
    const S small = constant<S>(kDouble ? 1e-7 : 1e-3);
    const S smallest = constant<S>(kDouble ? 1e-17 : 1e-8);
    for (int step = 0; step < kMaxSteps; ++step) {
      project_at(p_, yields);
      const S residual = lambda_ - needed_;
      low = select(residual > zero, p_, low);
      high = select(residual < zero, p_, high);
      const S along = residual / (needed_slope_ - lambda_by_radius_ * level_.slope);
      const S newton = stepped(law_.rule, p_, along);
      if (!any(active)) {
        // Squares the error, and gives a dual scalar its derivative.
        p_ = select(yields, newton, zero);
        break;
      }
      const auto inside = (newton >= low) & (newton <= high);
      const S next = select(inside, newton, constant<S>(0.5) * (low + high));
      S least = smallest;
      // The slope of a rate may be so large that less than rounding of the strain is much stress.
      if constexpr (requires { law_.rule.factor; }) {
        least = constant<S>(2e-16) * squares / (needed_slope_ - lambda_by_radius_ * level_.slope);
      }
      const S limit = max(select(inside, small, constant<S>(kDouble ? 1e-14 : 1e-6)) * next, least);
      const auto moves = active & (abs(next - p_) > limit);
      p_ = select(active, next, p_);
      active = moves;
    }
    project_at(p_, yields);
  }

  const Section& law_;
  const typename Section::State& before_;
  const SectionForce<S>& elastic_;
  const SectionForce<S>& trial_;
  const S& phi_;
  S elastic_area_, plastic_area_, plastic_by_radius_;
  SectionForce<S> plastic_by_point_, needed_by_point_;
  std::array<S, kBacks> along_{};
  S p_;
  Grown<S> level_;
  std::array<Grown<S>, kBacks> shift_{};
  Projection<S> projected_;
  SectionForce<S> by_radius_;
  S lambda_, lambda_by_radius_, needed_, needed_slope_;
};

}  // namespace detail

}  // namespace plastica::law
