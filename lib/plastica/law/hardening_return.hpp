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
///
/// Back stresses that recover, dX = C n dp - gamma X dp, decay in all directions alike, along the
/// flow and across it: X = exp(-gamma p) X(0) + source(p) n. So z^ less what is left of them moves
/// with p, and is projected where it is at p.
template <class Section>
class HardeningReturn {
 public:
  using S = std::remove_cvref_t<decltype(Section::cap[0])>;
  using Rule = decltype(Section::rule);
  static constexpr std::size_t kBacks = Rule::kBacks;

  HardeningReturn(const Section& law, const typename Section::State& before,
                  const SectionForce<S>& trial, const S& phi, const mask_t<S>& yields)
      : law_(law),
        before_(before),
        elastic_(law.elastic),
        begin_(trial),
        phi_begin_(phi),
        trial_(trial),
        phi_(phi) {
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
      const BackFlow<S>& of = flow_[k];
      after.back[k] = of.power * before_.back[k] + (of.source.value / length) * cut;
      back += after.back[k];
      const S source = law_.rule.source_integral(k, before_.equivalent, p_, of.decayed);
      work += plastic_area_ * (dot(before_.back[k], flow) / total * of.decayed + square * source);
    }
    z = projected_.point + back;
    after.equivalent = before_.equivalent + p_;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      const S d = law_.per_force[i] * part * cut[i];
      after.plastic[i] = before_.plastic[i] + d;
      after.accumulated[i] = before_.accumulated[i] + abs(d);
    }

    // T = A_p p + A_e sum sources depends on p, by itself, the radius and where the trial force has
    // moved to, and on z^ by the direction of z: d p = (d lambda~ at fixed p - d T)/(T' -
    // lambda~').
    const SectionForce<S> d_plastic = through_point(plastic_by_point_);
    const SectionForce<S> d_needed = through_point(needed_by_point_);
    SectionForce<S> d_lambda;
    for (std::size_t i = 0; i < kSectionAxes; ++i) d_lambda[i] = elastic_[i] * by_radius_[i];
    const SectionForce<S> d_p = (one / (needed_slope_ - lambda_slope_)) * (d_lambda - d_needed);
    const SectionForce<S> d_part =
        (one / total) * (p_ * d_plastic + (plastic_area_ + p_ * plastic_slope_) * d_p -
                         part * (d_needed + needed_slope_ * d_p));
    slope = identity<S, kSectionAxes>() -
            part * (identity<S, kSectionAxes>() - projected_.slope +
                    outer(trial_slope_ - point_slope_, d_p)) -
            outer(cut, d_part);
  }

 private:
  static constexpr int kMaxSteps = 40;

  /// Moves the trial force to what it is less the back stresses that are left at p.
  void move_to(const S& p) {
    for (std::size_t k = 0; k < kBacks; ++k) {
      flow_[k] = back_flow(law_.rule, k, before_.equivalent, p);
    }
    if constexpr (Rule::kRecovers) {
      trial_ = begin_;
      trial_slope_ = {};
      for (std::size_t k = 0; k < kBacks; ++k) {
        trial_ += (constant<S>(1) - flow_[k].power) * before_.back[k];
        trial_slope_ += (law_.rule.recovery(k) * flow_[k].power) * before_.back[k];
      }
      phi_ = gauge_value(law_.gauge, trial_);
    }
  }

  /// Projects on the surface of radius level(p); lambda~ and the derivatives by the radius follow
  /// from the homogeneity of both in (trial force, radius).
  void project_at(const S& p, const mask_t<S>& mask) {
    const S one = constant<S>(1);
    move_to(p);
    level_ = law_.rule.radius(before_.equivalent, p);
    const S inverse = one / level_.value;
    if constexpr (Rule::kRecovers) is_outside_ = phi_ > level_.value;
    const mask_t<S> outside = mask & is_outside_;
    const S overshoot = select(outside, phi_ * inverse - one, one);
    projected_ = project(law_.gauge, law_.compliance, inverse * trial_, overshoot, outside);
    projected_.point = level_.value * projected_.point;
    by_radius_ = inverse * (projected_.point - projected_.slope * trial_);
    lambda_ = constant<S>(0);
    S by_trial = constant<S>(0);
    S by_moved = constant<S>(0);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      lambda_ += elastic_[i] * (trial_[i] - projected_.point[i]) * projected_.point[i] * inverse;
      by_trial += elastic_[i] * trial_[i] * by_radius_[i];
      by_moved += elastic_[i] * trial_slope_[i] * by_radius_[i];
    }
    const S by_radius = (lambda_ - by_trial) * inverse;
    lambda_slope_ = by_radius * level_.slope + by_moved;
    point_slope_ = projected_.slope * trial_slope_ + level_.slope * by_radius_;
    find_needed(p, inverse);
  }

  /// T = A_p p + A_e sum sources in the direction of the projected point, with its derivative by p,
  /// what p does to the point and the radius among them, and by the point alone.
  void find_needed(const S& p, const S& inverse) {
    const S two = constant<S>(2);
    const SectionForce<S>& point = projected_.point;
    const S square = inverse * inverse;
    SectionForce<S> energy, work;
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      energy[i] = elastic_[i] * point[i];
      work[i] = law_.area[i] * point[i];
    }
    elastic_area_ = dot(energy, point) * square;
    plastic_area_ = dot(work, point) * square;
    plastic_by_point_ = (two * square) * work;
    const S shrinks = two * inverse * level_.slope;
    plastic_slope_ = dot(plastic_by_point_, point_slope_) - plastic_area_ * shrinks;
    needed_ = plastic_area_ * p;
    needed_by_point_ = p * plastic_by_point_;
    needed_slope_ = plastic_area_ + p * plastic_slope_;
    const SectionForce<S> elastic_by_point = (two * square) * energy;
    const S elastic_slope = dot(elastic_by_point, point_slope_) - elastic_area_ * shrinks;
    for (std::size_t k = 0; k < kBacks; ++k) {
      const Grown<S>& source = flow_[k].source;
      needed_ += elastic_area_ * source.value;
      needed_slope_ += elastic_area_ * source.slope + source.value * elastic_slope;
      needed_by_point_ += source.value * elastic_by_point;
    }
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

  /// Newton for lambda~(p) = A_p p + A_e sum sources(p), inside of a bracket. Where the trial force
  /// has moved into the surface, p is too large.
  void solve(const mask_t<S>& yields) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    is_outside_ = yields;
    S low = zero;
    // lambda~ is at most the support function of the surface at A times the trial force, as at
    // radius zero, which moves by no more than the back stresses that there are. A gauge is convex
    // and 1 at each axis' cap, so that the squares of a point of the surface sum up to a quarter at
    // least.
    S most = zero;
    S squares = zero;
    S least_area = law_.area[0];
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      squares += elastic_[i] * begin_[i] * begin_[i];
      S reach = abs(begin_[i]);
      for (std::size_t k = 0; k < kBacks; ++k) reach += abs(before_.back[k][i]);
      most += elastic_[i] * reach;
      least_area = min(least_area, law_.area[i]);
    }
    S high = select(yields, constant<S>(4) * most / least_area, zero);
    const S begins = law_.rule.radius(before_.equivalent, zero).value;
    p_ = select(yields, first_flow(law_.rule, S(phi_begin_ / begins - one), high), zero);
    auto active = yields;
    constexpr bool kDouble = sizeof(real_t<S>) == 8;
    const S small = constant<S>(kDouble ? 1e-7 : 1e-3);
    const S smallest = constant<S>(kDouble ? 1e-17 : 1e-8);
    for (int step = 0; step < kMaxSteps; ++step) {
      project_at(p_, yields);
      const S residual = select(is_outside_, lambda_ - needed_, -one);
      low = select(residual > zero, p_, low);
      high = select(residual < zero, p_, high);
      const S along = residual / (needed_slope_ - lambda_slope_);
      const S newton = stepped(law_.rule, p_, along);
      if (!any(active)) {
        // Squares the error, and gives a dual scalar its derivative.
        p_ = select(yields, newton, zero);
        break;
      }
      const auto inside = is_outside_ & (newton >= low) & (newton <= high);
      const S next = select(inside, newton, constant<S>(0.5) * (low + high));
      S least = smallest;
      // The slope of a rate may be so large that less than rounding of the strain is much stress.
      if constexpr (requires { law_.rule.factor; }) {
        least = constant<S>(2e-16) * squares / (needed_slope_ - lambda_slope_);
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
  const SectionForce<S>& begin_;  ///< z^ less the back stresses before
  const S& phi_begin_;            ///< its gauge
  SectionForce<S> trial_;         ///< z^ less what is left of them at p
  SectionForce<S> trial_slope_{};
  S phi_;
  mask_t<S> is_outside_{};  ///< whether the trial force is outside of the surface at p
  S elastic_area_, plastic_area_, plastic_slope_;
  SectionForce<S> plastic_by_point_, needed_by_point_;
  S p_;
  Grown<S> level_;
  std::array<BackFlow<S>, kBacks> flow_{};
  Projection<S> projected_;
  SectionForce<S> by_radius_, point_slope_;
  S lambda_, lambda_slope_, needed_, needed_slope_;
};

}  // namespace detail

}  // namespace plastica::law
