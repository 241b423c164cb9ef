#pragma once

#include <array>
#include <cstddef>

#include "plastica/base/matrix.hpp"
#include "plastica/law/plastic_work.hpp"

/// The uniaxial laws under normal and shear stress together: a fibre that is pulled and sheared.
///
/// Yield condition: |xi| = R(p), xi = (sigma, r tau) - back stress, r = yield stress over shear
/// yield stress; with r = sqrt(3) it is von Mises'. In (sigma, t = r tau), whose strains are (eps,
/// gamma/r), flow and hardening are those of one stress of the size |xi|: of normal stress alone it
/// is the uniaxial law, of shear stress alone that law with stresses over r and strains times r
/// (law/uniaxial_material.hpp). Stiffnesses are E and r^2 G.
///
/// The flow of an increment has the direction n = xi/R of its end (closest-point return):
///   sigma_k = trial_k - K_k p n_k,
///   X_j = X_j0 exp(-gamma_j p) + C_j/gamma_j (1 - exp(-gamma_j p)) n
/// so that xi_k = R b_k/a_k with b = trial - sum X_j0 exp(-gamma_j p) and
///   a_k = R(p) + K_k p + sum C_j (1 - exp(-gamma_j p))/gamma_j,
/// and p solves sum (b_k/a_k)^2 = 1. While the direction stays, this is exact, however long the
/// increment; where it turns, of first order in the increment.
/// Source: Simo & Hughes, Computational Inelasticity (1998), secs. 3.3 and 3.4, written for two
/// stresses whose stiffnesses differ.
namespace plastica::law {

/// A uniaxial law for normal and shear stress. @tparam Uniaxial  see FibreSection
template <class S, class Uniaxial>
struct Biaxial {
  static constexpr std::size_t kBacks = Uniaxial::kBacks;
  using Pair = Vec<S, 2>;

  Uniaxial normal;  ///< under normal stress alone
  S per_ratio;      ///< 1/r: shear yield stress over yield stress [1]
  Pair stiffness;   ///< E, r^2 G [Pa]
  Pair compliance;  ///< one over them [1/Pa]

  struct State {
    Pair plastic{};                   ///< permanent strain, of shear over r [1]
    S accumulated{};                  ///< sum of p [1]
    std::array<Pair, kBacks> back{};  ///< back stresses, of shear times r [Pa]
  };
};

/// What `respond` returns, in true stresses and strains (normal, shear).
template <class S, class State>
struct BiaxialResponse {
  Vec<S, 2> stress;      ///< [Pa]
  Mat<S, 2, 2> tangent;  ///< d stress / d strain, symmetric but for recovery of back stress [Pa]
  S plastic_work;        ///< of the increment [J/m^3]
  S elastic_energy;      ///< [J/m^3]
  State state;
};

namespace detail {

/// The return of a fibre: p, and what follows from it.
template <class S, class Uniaxial>
class BiaxialReturn {
 public:
  using Law = Biaxial<S, Uniaxial>;
  using Pair = Vec<S, 2>;
  static constexpr std::size_t kBacks = Law::kBacks;

  BiaxialReturn(const Law& law, const typename Law::State& before, const Pair& trial)
      : law_(law), before_(before), trial_(trial) {
    at(constant<S>(0));
  }

  /// Newton's method on 1/|b/a| = 1, concave and rising for ideal plasticity, so that it comes from
  /// below and cannot leave; a bracket keeps it there for the others.
  void solve(const mask_t<S>& yields) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    // At `high`, K p alone is larger than sqrt(2) times all that b can be.
    S most = abs(trial_[0]) + abs(trial_[1]);
    for (const Pair& back : before_.back) most += abs(back[0]) + abs(back[1]);
    S low = zero;
    S high = constant<S>(1.5) * most * max(law_.compliance[0], law_.compliance[1]);
    const S enough = constant<S>(kIsDouble<S> ? 1e-7 : 1e-3);
    auto active = yields;
    // Where the root is at the latest if both stiffnesses are the larger one, without hardening of
    // the increment: from there Newton's method has two or three steps to go.
    S p = select(yields, first_guess(high), zero);
    at(p);
    for (int step = 0; step < kMaxReturnSteps; ++step) {
      low = select(size_ > one, p, low);
      high = select(size_ < one, p, high);
      const S newton = stepped(law_.normal, p, newton_step());
      const auto inside = (newton >= low) & (newton <= high);
      const S next = select(inside, newton, constant<S>(0.5) * (low + high));
      const auto moves = active & (abs(next - p) > enough * next);
      p = select(active, next, p);
      at(p);
      active = moves;
      if (!any(active)) break;
    }
    // Squares what is left, and gives a dual scalar the derivative of the root.
    p = select(yields, p + newton_step(), zero);
    at(p);
  }

  void finish(const mask_t<S>& yields, BiaxialResponse<S, typename Law::State>& now) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    Pair stress;  // (sigma, r tau)
    Pair weight;  // dp = weight . d strain, since n . dn = 0
    const S falls = select(yields, falls_, one);
    for (std::size_t k = 0; k < 2; ++k) {
      stress[k] = trial_[k] - law_.stiffness[k] * p_ * n_[k];
      weight[k] = select(yields, n_[k] * law_.stiffness[k] / (a_[k] * falls), zero);
    }
    Mat<S, 2, 2> slope;
    for (std::size_t k = 0; k < 2; ++k) {
      // d n_k = (K_k d e_k + (b'_k - n_k a'_k) dp)/a_k
      const S along = n_[k] + p_ * (b_slope_[k] - n_[k] * a_slope_[k]) / a_[k];
      for (std::size_t m = 0; m < 2; ++m) slope(k, m) = -law_.stiffness[k] * along * weight[m];
      slope(k, k) += law_.stiffness[k] * (one - p_ * law_.stiffness[k] / a_[k]);
    }
    const S inverse = law_.per_ratio;
    now.stress = {{stress[0], stress[1] * inverse}};
    now.tangent(0, 0) = slope(0, 0);
    now.tangent(0, 1) = slope(0, 1) * inverse;
    now.tangent(1, 0) = slope(1, 0) * inverse;
    now.tangent(1, 1) = slope(1, 1) * inverse * inverse;
    now.elastic_energy = constant<S>(0.5) * (stress[0] * stress[0] * law_.compliance[0] +
                                             stress[1] * stress[1] * law_.compliance[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      now.state.plastic[k] = before_.plastic[k] + p_ * n_[k];
    }
    now.state.accumulated = before_.accumulated + p_;
    for (std::size_t j = 0; j < kBacks; ++j) {
      now.state.back[j] = flow_[j].power * before_.back[j] + flow_[j].source.value * n_;
    }
    now.plastic_work = select(yields, work(), zero);
  }

 private:
  /// Radial return with the larger stiffness and the slope of the begin: for ideal plasticity not
  /// beyond the root, as all a_k are at most R + K p.
  S first_guess(const S& most) const {
    if constexpr (requires { law_.normal.factor; }) {
      return first_flow(law_.normal, S(size_ - constant<S>(1)), most);
    }
    S square = constant<S>(0);
    for (std::size_t k = 0; k < 2; ++k) square += a_[k] * n_[k] * a_[k] * n_[k];
    return (sqrt(square) - radius_) / max(a_slope_[0], a_slope_[1]);
  }

  /// Everything at a p.
  void at(const S& p) {
    p_ = p;
    const Grown<S> radius = law_.normal.radius(before_.accumulated, p);
    radius_ = radius.value;
    Pair b = trial_;
    b_slope_ = {};
    S grown = radius.value;
    S slope = radius.slope;
    for (std::size_t j = 0; j < kBacks; ++j) {
      flow_[j] = back_flow(law_.normal, j, before_.accumulated, p);
      const Pair left = flow_[j].power * before_.back[j];
      b -= left;
      if constexpr (Uniaxial::kRecovers) b_slope_ += law_.normal.recovery(j) * left;
      grown += flow_[j].source.value;
      slope += flow_[j].source.slope;
    }
    S square = constant<S>(0);
    falls_ = constant<S>(0);
    for (std::size_t k = 0; k < 2; ++k) {
      a_[k] = grown + law_.stiffness[k] * p;
      a_slope_[k] = slope + law_.stiffness[k];
      n_[k] = b[k] / a_[k];
      square += n_[k] * n_[k];
      falls_ += n_[k] * (n_[k] * a_slope_[k] - b_slope_[k]) / a_[k];
    }
    size_ = sqrt(square);
  }

  /// With q = |b/a|^2 and q' = -2 falls: of 1/sqrt(q) - 1, q (sqrt(q) - 1)/falls.
  S newton_step() const { return size_ * size_ * (size_ - constant<S>(1)) / falls_; }

  /// The stress along n, over p: back stresses along n follow the uniaxial rule.
  S work() const {
    std::array<S, kBacks> along;
    for (std::size_t j = 0; j < kBacks; ++j) along[j] = dot(before_.back[j], n_);
    return flow_work(law_.normal, before_.accumulated, p_, along);
  }

  const Law& law_;
  const typename Law::State& before_;
  Pair trial_;
  S p_, radius_, size_, falls_;
  Pair n_, a_, a_slope_, b_slope_;
  std::array<BackFlow<S>, kBacks> flow_;
};

}  // namespace detail

/// @param strain  normal and shear (the engineer's) [1]
template <class S, class Uniaxial>
inline BiaxialResponse<S, typename Biaxial<S, Uniaxial>::State> respond(
    const Biaxial<S, Uniaxial>& law, const typename Biaxial<S, Uniaxial>::State& before,
    const Vec<S, 2>& strain) {
  const S& inverse = law.per_ratio;
  const Vec<S, 2> trial{{law.stiffness[0] * (strain[0] - before.plastic[0]),
                         law.stiffness[1] * (strain[1] * inverse - before.plastic[1])}};
  Vec<S, 2> relative = trial;
  for (const Vec<S, 2>& back : before.back) relative -= back;
  const S radius = law.normal.radius(before.accumulated, constant<S>(0)).value;
  const auto yields = dot(relative, relative) > radius * radius;
  BiaxialResponse<S, typename Biaxial<S, Uniaxial>::State> now;
  if (any(yields)) {
    detail::BiaxialReturn<S, Uniaxial> back(law, before, trial);
    back.solve(yields);
    back.finish(yields, now);
    return now;
  }
  now.stress = {{trial[0], trial[1] * inverse}};
  now.tangent(0, 0) = law.stiffness[0];
  now.tangent(1, 1) = law.stiffness[1] * inverse * inverse;
  now.elastic_energy = constant<S>(0.5) * (trial[0] * trial[0] * law.compliance[0] +
                                           trial[1] * trial[1] * law.compliance[1]);
  now.plastic_work = constant<S>(0);
  now.state = before;
  return now;
}

/// @param normal, shear  of the same material; the shear one gives stiffness and yield stress
template <class Uniaxial, class S>
inline Biaxial<S, Uniaxial> biaxial_law(const UniaxialMaterial<S>& normal,
                                        const UniaxialMaterial<S>& shear,
                                        const MaterialValues<S>& material) {
  Biaxial<S, Uniaxial> law;
  law.normal = Uniaxial::of(normal, material);
  const S ratio = normal.yield / shear.yield;
  law.per_ratio = constant<S>(1) / ratio;
  law.stiffness = {{normal.stiffness, ratio * ratio * shear.stiffness}};
  for (std::size_t k = 0; k < 2; ++k) law.compliance[k] = constant<S>(1) / law.stiffness[k];
  return law;
}

}  // namespace plastica::law
