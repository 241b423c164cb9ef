#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "plastica/law/biaxial.hpp"
#include "plastica/law/fibre.hpp"

namespace plastica::law {

/// A section cut into a grid of fibres, each under normal and shear stress together: bending about
/// both axes, torsion and axial force as they yield together.
///
/// Signs as in law/fibre.hpp. The shear strain of fibre i is
///   lever_i (twist + h_1i beta_1 + h_2i beta_2).
/// The lever is the radius in a round section, in others Saint-Venant's shear, drawn to the fully
/// plastic torque of the sand heap (law/shear_levers.hpp). beta are two ways to warp beyond that:
/// while fibres far from the axis of bending yield, shear goes over to the others. They do no work
/// from outside, so sum A lever h tau = 0 for each, which is solved here; h are the cosine and sine
/// of twice the angle, less what would change the torque while all is elastic (sum A lever^2 h = 0)
/// or where all has yielded by torsion (sum A lever h = 0). Without them shear strains grow by the
/// twist alone, and a tube under bending with torsion carries 3.6 % too much; with them 0.3 %.
/// @tparam Uniaxial  one of `UniaxialLaws`
template <class S, class Uniaxial>
struct FibreGrid {
  const FibreLayout* layout;  ///< of FibrePlane::Both; lives at least as long
  Biaxial<S, Uniaxial> fibre;
  Vec<S, 2> warp_cap;  ///< tau_y sum A |lever h| [N m]: what sum A lever h tau is small against
  Vec<S, 2> warp_stiffness;  ///< G sum A (lever h)^2 [N m^2]

  /// Calls `use` with each uniaxial law.
  template <class Use>
  void each_uniaxial(const Use& use) {
    use(fibre.normal);
  }

  static constexpr bool kSeesAxial = true;
  /// To which forces are what they are, over the yielding section's, since beta is found to 1e-12
  /// [1].
  static constexpr double kForceTolerance = 1e-11;

  /// Of one fibre; a joint has an array of `layout->states()` of them, the last one with beta for
  /// its plastic strain.
  using State = typename Biaxial<S, Uniaxial>::State;
};

namespace detail {

/// Sums over the fibres at one beta.
template <class S>
struct GridSums {
  SectionResponse<S> section{};
  Vec<S, 2> warping;                ///< sum A lever h tau [N m]
  Mat<S, 2, 2> by_beta;             ///< its slope
  Mat<S, kSectionAxes, 2> forces;   ///< d force / d beta
  Mat<S, 2, kSectionAxes> strains;  ///< d warping / d strain
};

template <class S, class Uniaxial>
inline GridSums<S> sum_grid(const FibreGrid<S, Uniaxial>& law,
                            const typename FibreGrid<S, Uniaxial>::State* before,
                            typename FibreGrid<S, Uniaxial>::State* after,
                            const SectionStrain<S>& strain, const Vec<S, 2>& beta) {
  constexpr std::array<Axis, 3> kNormal{kBendingX, kBendingY, kAxial};
  const FibreLayout& layout = *law.layout;
  GridSums<S> sum;
  SectionResponse<S>& now = sum.section;
  for (std::size_t i = 0; i < layout.area.size(); ++i) {
    const S area = constant<S>(layout.area[i]);
    // d normal strain / d (curvatures, axial strain); d shear strain / d (twist, beta).
    const std::array<S, 3> arm{constant<S>(layout.depth[i]), constant<S>(layout.across[i]),
                               constant<S>(1)};
    const S lever = constant<S>(layout.lever[i]);
    const Vec<S, 2> warp{{constant<S>(layout.warp[0][i]), constant<S>(layout.warp[1][i])}};
    const S normal = strain[kAxial] + arm[0] * strain[kBendingX] + arm[1] * strain[kBendingY];
    const auto fibre = respond(law.fibre, before[i],
                               Vec<S, 2>{{normal, lever * strain[kTorsion] + dot(warp, beta)}});
    after[i] = fibre.state;
    now.plastic_work += area * fibre.plastic_work;
    now.elastic_energy += area * fibre.elastic_energy;
    const S force = area * fibre.stress[0];
    const S shear = area * fibre.stress[1];
    const S nn = area * fibre.tangent(0, 0);
    const S ns = area * fibre.tangent(0, 1);
    const S sn = area * fibre.tangent(1, 0);
    const S ss = area * fibre.tangent(1, 1);
    for (std::size_t a = 0; a < 3; ++a) {
      now.force[kNormal[a]] += force * arm[a];
      const S stiff = nn * arm[a];
      for (std::size_t b = 0; b < 3; ++b) now.tangent(kNormal[a], kNormal[b]) += stiff * arm[b];
      now.tangent(kNormal[a], kTorsion) += ns * arm[a] * lever;
      now.tangent(kTorsion, kNormal[a]) += sn * arm[a] * lever;
      for (std::size_t j = 0; j < 2; ++j) {
        sum.forces(kNormal[a], j) += ns * arm[a] * warp[j];
        sum.strains(j, kNormal[a]) += sn * arm[a] * warp[j];
      }
    }
    now.force[kTorsion] += shear * lever;
    now.tangent(kTorsion, kTorsion) += ss * lever * lever;
    for (std::size_t j = 0; j < 2; ++j) {
      sum.warping[j] += shear * warp[j];
      const S stiff = ss * warp[j];
      sum.forces(kTorsion, j) += stiff * lever;
      sum.strains(j, kTorsion) += stiff * lever;
      for (std::size_t m = 0; m < 2; ++m) sum.by_beta(j, m) += stiff * warp[m];
    }
  }
  return sum;
}

/// One over the slope, which is kept regular where all fibres yield under shear.
template <class S, class Uniaxial>
inline Mat<S, 2, 2> flexibility(const FibreGrid<S, Uniaxial>& law, Mat<S, 2, 2> k) {
  const S rest = constant<S>(kIsDouble<S> ? 1e-9 : 1e-4);
  for (std::size_t j = 0; j < 2; ++j) k(j, j) += rest * law.warp_stiffness[j];
  const S inverse = constant<S>(1) / (k(0, 0) * k(1, 1) - k(0, 1) * k(1, 0));
  Mat<S, 2, 2> f;
  f(0, 0) = k(1, 1) * inverse;
  f(1, 1) = k(0, 0) * inverse;
  f(0, 1) = -k(0, 1) * inverse;
  f(1, 0) = -k(1, 0) * inverse;
  return f;
}

inline constexpr int kMaxWarpings = 60;

}  // namespace detail

/// Newton's method for beta from where it was, its step halved where the sums would grow. What does
/// not converge has forces that are no numbers, so that the solver tries a shorter increment.
/// @param before, after  states (layout->states()), not the same
template <class S, class Uniaxial>
inline SectionResponse<S> respond(const FibreGrid<S, Uniaxial>& law,
                                  const typename FibreGrid<S, Uniaxial>::State* before,
                                  typename FibreGrid<S, Uniaxial>::State* after,
                                  const SectionStrain<S>& strain) {
  const S enough = constant<S>(kIsDouble<S> ? 1e-12 : 1e-5);
  const std::size_t last = law.layout->area.size();
  Vec<S, 2> base = before[last].plastic;
  Vec<S, 2> beta = base;
  Vec<S, 2> step;
  S least = constant<S>(std::numeric_limits<real_t<S>>::infinity());
  detail::GridSums<S> sum;
  mask_t<S> done{};
  bool polished = !kCarriesDerivatives<S>;
  for (int pass = 0; pass < detail::kMaxWarpings; ++pass) {
    sum = detail::sum_grid(law, before, after, strain, beta);
    const S size =
        max(abs(sum.warping[0]) / law.warp_cap[0], abs(sum.warping[1]) / law.warp_cap[1]);
    done = size <= enough;
    const bool all = !any(!done);
    if (all && polished) break;
    polished = polished || all;
    const auto grows = size > least;
    const Vec<S, 2> newton =
        -constant<S>(1) * (detail::flexibility(law, sum.by_beta) * sum.warping);
    for (std::size_t j = 0; j < 2; ++j) {
      base[j] = select(grows, base[j], beta[j]);
      step[j] = select(grows, constant<S>(0.5) * step[j], newton[j]);
      // A derivative comes from one step more, with which the value stays.
      const S next = base[j] + step[j];
      beta[j] = all ? next : select(done, beta[j], next);
    }
    least = select(grows, least, size);
  }
  after[last].plastic = beta;
  SectionResponse<S> now = sum.section;
  now.tangent -= sum.forces * (detail::flexibility(law, sum.by_beta) * sum.strains);
  const S lost = constant<S>(std::numeric_limits<real_t<S>>::quiet_NaN());
  for (std::size_t k = 0; k < kSectionAxes; ++k) now.force[k] = select(done, now.force[k], lost);
  return now;
}

/// @param layout    of FibrePlane::Both, of the same section; kept by address
/// @tparam Uniaxial see FibreSection
template <class Uniaxial, class S>
inline FibreGrid<S, Uniaxial> fibre_grid(const FibreLayout& layout, const SectionForm& form,
                                         const MaterialValues<S>& material) {
  const UniaxialMaterial<S> shear = fibre_material(form, kTorsion, material);
  FibreGrid<S, Uniaxial> law{
      &layout,
      biaxial_law<Uniaxial>(fibre_material(form, kAxial, material), shear, material),
      {},
      {}};
  for (std::size_t j = 0; j < 2; ++j) {
    double first = 0.0;
    double second = 0.0;
    for (std::size_t i = 0; i < layout.area.size(); ++i) {
      first += layout.area[i] * std::fabs(layout.warp[j][i]);
      second += layout.area[i] * layout.warp[j][i] * layout.warp[j][i];
    }
    law.warp_cap[j] = constant<S>(first) * shear.yield;
    law.warp_stiffness[j] = constant<S>(second) * shear.stiffness;
  }
  return law;
}

}  // namespace plastica::law
