#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "plastica/base/matrix.hpp"
#include "plastica/law/linear_facet.hpp"
#include "plastica/law/section_form.hpp"
#include "plastica/law/section_response.hpp"

/// Yield surfaces of a section as gauges.
///
/// A gauge phi of the forces over their caps, z = (m_x, m_y, t, n), is convex and homogeneous of
/// degree one; the surface is phi = 1. All of ours see only the size of each component, so phi
/// lives in the orthant u >= 0 and grows with each u_i: u = (|m_x|, |m_y|, |t|, |n|), or, where a
/// round section sees only the resultant, u = (|(m_x, m_y)|, 0, |t|, |n|).
///
/// There phi is the largest of `kFacets` facets, of which each is given as the smooth function
/// f = phi_facet^2/2 with gradient and Hessian. The kinks of phi on the axes become the
/// bounds u >= 0, those between facets are left to the projection (project.hpp): nothing is
/// rounded.
namespace plastica::law {

/// Stands for an infinite curvature in `axis_curvature()`, whose entry (j, i) is the second
/// derivative of phi by u_i at the point 1 of the axis j: how fast the return of a force on that
/// axis gives way to a small other component.
inline constexpr double kKink = 1e30;

/// One facet f(u) = phi_facet(u)^2/2 of a yield surface, which is f = 1/2.
template <class S>
struct GaugeFacet {
  S value;
  SectionForce<S> gradient;
  SectionTangent<S> hessian;
};

/// An entry of one of a gauge's arrays by its number.
template <class S, std::size_t K>
inline S pick(const std::array<S, K>& of, const S& number) {
  if constexpr (std::is_floating_point_v<S>) {
    return of[static_cast<std::size_t>(max(number, constant<S>(0)))];
  } else {
    S found = of[0];
    for (std::size_t k = 1; k < K; ++k) {
      found = select(number > constant<S>(static_cast<double>(k) - 0.5), of[k], found);
    }
    return found;
  }
}

/// First yield of elastic stresses: the largest of
///   sqrt((n + xi_k m_x + eta_k m_y)^2 + tau_k^2 t^2)
/// over points k of the perimeter. xi, eta: stress there over that of the extreme fibre; tau: shear
/// stress there over the largest. sigma^2 + 3 tau^2 (von Mises) with the two yield stresses as
/// given.
/// @tparam Round  of a circle or round tube: m_x stands for the resultant, K = 1, xi = 1, eta = 0
template <class S, std::size_t K, bool Round>
struct FirstYieldGauge {
  using Scalar = S;
  static constexpr std::size_t kFacets = K;
  static constexpr bool kRound = Round;

  std::array<S, K> xi, eta, tau_squared;  ///< the first has xi = 1, eta = 0; for y it is number K/2

  GaugeFacet<S> facet(std::size_t k, const SectionForce<S>& u) const {
    const S stress = u[kAxial] + xi[k] * u[kBendingX] + eta[k] * u[kBendingY];
    const S shear = tau_squared[k] * u[kTorsion];
    GaugeFacet<S> f;
    f.value = constant<S>(0.5) * (stress * stress + shear * u[kTorsion]);
    f.gradient = {{xi[k] * stress, eta[k] * stress, shear, stress}};
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    f.hessian = {{xi[k] * xi[k], xi[k] * eta[k], zero, xi[k],     //
                  xi[k] * eta[k], eta[k] * eta[k], zero, eta[k],  //
                  zero, zero, tau_squared[k], zero,               //
                  xi[k], eta[k], zero, one}};
    return f;
  }

  /// The facet of a number that may be another in each lane.
  GaugeFacet<S> facet_at(const S& number, const SectionForce<S>& u) const {
    const FirstYieldGauge<S, 1, Round> alone{
        {pick(xi, number)}, {pick(eta, number)}, {pick(tau_squared, number)}};
    return alone.facet(0, u);
  }

  /// The only facet of a surface that has but one.
  LinearFacet<S> linear_facet(const SectionForce<S>& u) const requires(K == 1) {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S kink = constant<S>(kKink);
    const S y = select(eta[0] > zero, kink, zero);
    const auto applies = u[kAxial] >= zero;  // always
    return {
        {{xi[0], eta[0], zero, one}}, tau_squared[0], applies, {{kink, y, tau_squared[0], kink}}};
  }

  /// See `kKink`.
  SectionTangent<S> axis_curvature() const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S kink = constant<S>(kKink);
    // Beside a large torque counts the longer side, whose middle has the largest shear stress.
    const S x = select(tau_squared[0] < tau_squared[K / 2], zero, one);
    const S y = select(tau_squared[K / 2] < tau_squared[0], zero, one);
    return {{zero, kink, tau_squared[0], kink,      //
             kink, zero, tau_squared[K / 2], kink,  //
             x, y, zero, one,                       //
             kink, kink, one, zero}};
  }
};

/// A fully plastic section: sqrt(Gamma^2 + t^2) with Gamma of bending and axial force. A lower
/// bound where Gamma is one: its stress field scaled by sqrt(1 - t^2) and that of torsion by t are
/// admissible together.
///
/// Gamma^2 - h Gamma - Q = 0, for a the larger of the moments and b the other:
///   h = m_a + (1 - e) n,  Q = 3/4 m_b^2 + n m_b/10 + e n^2.
/// - Without n: m_a + 3/4 m_b^2 = 1, exact for a rectangle (the neutral axis cuts the sides along
///   b), with continuous first derivatives where the two moments change places.
/// - One moment: m = (1 - n)(1 + e n), exact with e = 1 for a rectangle; otherwise e is the largest
///   that is nowhere outside (`GaugeForm`).
/// - The mixed term makes it safe for a rectangle with both moments and n (`GaugeForm`).
template <class S>
struct PlasticGauge {
  using Scalar = S;
  static constexpr std::size_t kFacets = 2;
  static constexpr bool kRound = false;

  S axial;  ///< e [1], 0..1

  GaugeFacet<S> facet(std::size_t k, const SectionForce<S>& u) const {
    const std::size_t a = k == 0 ? kBendingX : kBendingY;
    const std::size_t b = k == 0 ? kBendingY : kBendingX;
    const S one = constant<S>(1);
    const S two = constant<S>(2);
    const S half = constant<S>(0.5);
    const S linear = one - axial;
    const S mixed = constant<S>(0.1);
    const S n = u[kAxial];
    const S h = u[a] + linear * n;
    const S q = constant<S>(0.75) * u[b] * u[b] + mixed * n * u[b] + axial * n * n;
    // The tiny number keeps 0/0 away at the origin.
    const S inverse_root = one / sqrt(h * h + constant<S>(4) * q + constant<S>(1e-30));
    const S gamma = half * (h + (h * h + constant<S>(4) * q) * inverse_root);
    // Gradient of the root.
    SectionForce<S> bend;
    bend[a] = h;
    bend[b] = constant<S>(3) * u[b] + two * mixed * n;
    bend[kAxial] = h * linear + two * (mixed * u[b] + two * axial * n);
    bend = inverse_root * bend;
    SectionForce<S> slope;  // of Gamma
    slope[a] = half * (one + bend[a]);
    slope[b] = half * bend[b];
    slope[kAxial] = half * (linear + bend[kAxial]);
    GaugeFacet<S> f;
    f.value = half * (gamma * gamma + u[kTorsion] * u[kTorsion]);
    f.gradient = gamma * slope;
    f.gradient[kTorsion] = u[kTorsion];
    // Gamma'' = (h' h'^T + 2 Q'' - bend bend^T)/(2 root).
    SectionTangent<S> curve = -one * outer(bend, bend);
    curve(a, a) += one;
    curve(a, kAxial) += linear;
    curve(kAxial, a) += linear;
    curve(b, b) += constant<S>(3);
    curve(b, kAxial) += two * mixed;
    curve(kAxial, b) += two * mixed;
    curve(kAxial, kAxial) += linear * linear + constant<S>(4) * axial;
    f.hessian = outer(slope, slope) + (half * gamma * inverse_root) * curve;
    f.hessian(kTorsion, kTorsion) = one;
    return f;
  }

  GaugeFacet<S> facet_at(const S& number, const SectionForce<S>& u) const {
    const auto second = number > constant<S>(0.5);
    if constexpr (std::is_floating_point_v<S>) {
      return facet(second ? 1 : 0, u);
    } else {
      const GaugeFacet<S> f = facet(0, u);
      const GaugeFacet<S> g = facet(1, u);
      return {select(second, g.value, f.value), select(second, g.gradient, f.gradient),
              select(second, g.hessian, f.hessian)};
    }
  }

  /// One moment and torsion, without axial force, are a circle.
  LinearFacet<S> linear_facet(const SectionForce<S>& u) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const auto planar = static_cast<mask_t<S>>((u[kAxial] <= zero) &
                                               ((u[kBendingX] <= zero) | (u[kBendingY] <= zero)));
    const SectionTangent<S> curvature = axis_curvature();
    const S other = constant<S>(1.5);
    return {{{one, one, zero, zero}}, one, planar, {{other, other, one, curvature(0, kAxial)}}};
  }

  /// See `kKink`.
  SectionTangent<S> axis_curvature() const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S kink = constant<S>(kKink);
    const S other = constant<S>(1.5);
    const S n = select(axial < one, kink, constant<S>(2));
    return {{zero, other, one, n,  //
             other, zero, one, n,  //
             one, one, zero, one,  //
             kink, kink, one, zero}};
  }
};

/// Terms of the radius of `PlasticCurveGauge`.
inline constexpr std::size_t kRadiusTerms = 10;

/// A fully plastic section whose bending has one moment, be it that of its plane or the resultant
/// of a round section: sqrt(Gamma^2 + t^2), as `PlasticGauge`, with the section's own curve m(n).
///
/// With w = m + n and p = n/w, Gamma = w R(p) is 1 on the curve if R = 1/(m + n) there. So with
/// R a function of p alone Gamma is homogeneous, and
///   Gamma_m = R - p R',  Gamma_n = R + (1 - p) R',  Gamma'' = R''/w (p, p - 1)(p, p - 1)^T:
/// convex where R'' >= 0.
template <class S>
struct PlasticCurveGauge {
  using Scalar = S;
  static constexpr std::size_t kFacets = 1;
  static constexpr bool kRound = true;

  std::array<S, kRadiusTerms> radius;  ///< R(p) = sum radius_k p^k

  GaugeFacet<S> facet(std::size_t /*k*/, const SectionForce<S>& u) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    // The tiny number keeps 0/0 away at the origin.
    const S w = u[kBendingX] + u[kAxial];
    const S p = u[kAxial] / (w + constant<S>(1e-30));
    S r = zero, slope = zero, curve = zero;  // R, R', R''/2
    for (std::size_t k = kRadiusTerms; k-- > 0;) {
      curve = curve * p + slope;
      slope = slope * p + r;
      r = r * p + radius[k];
    }
    const S gamma = w * r;
    SectionForce<S> by;
    by[kBendingX] = r - p * slope;
    by[kAxial] = r + (one - p) * slope;
    SectionForce<S> across;
    across[kBendingX] = p;
    across[kAxial] = p - one;
    GaugeFacet<S> f;
    f.value = constant<S>(0.5) * (gamma * gamma + u[kTorsion] * u[kTorsion]);
    f.gradient = gamma * by;
    f.gradient[kTorsion] = u[kTorsion];
    f.hessian = outer(by, by) + (constant<S>(2) * r * curve) * outer(across, across);
    f.hessian(kTorsion, kTorsion) = one;
    return f;
  }

  GaugeFacet<S> facet_at(const S& /*number*/, const SectionForce<S>& u) const {
    return facet(0, u);
  }

  /// The moment and torsion, without axial force, are a circle.
  LinearFacet<S> linear_facet(const SectionForce<S>& u) const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const auto planar = static_cast<mask_t<S>>(u[kAxial] <= zero);
    return {{{one, one, zero, zero}}, one, planar, {{one, one, one, beside_bending()}}};
  }

  /// See `kKink`.
  SectionTangent<S> axis_curvature() const {
    const S zero = constant<S>(0);
    const S one = constant<S>(1);
    const S kink = constant<S>(kKink);
    const S n = beside_bending();
    return {{zero, one, one, n,    //
             one, zero, one, n,    //
             one, one, zero, one,  //
             kink, kink, one, zero}};
  }

 private:
  /// Every curve begins with R' = -1: a small axial force takes no moment. Then Gamma_nn = R''.
  S beside_bending() const { return constant<S>(2) * radius[2]; }
};

/// Where a force lies in the orthant: the coordinates u of `gauge.hpp`.
template <class Gauge>
inline SectionForce<typename Gauge::Scalar> orthant_of(
    const SectionForce<typename Gauge::Scalar>& z) {
  using S = typename Gauge::Scalar;
  SectionForce<S> u{{abs(z[0]), abs(z[1]), abs(z[2]), abs(z[3])}};
  if constexpr (Gauge::kRound) {
    const S square = z[0] * z[0] + z[1] * z[1];
    const S zero = constant<S>(0);
    const auto some = square > zero;
    // Without the root of zero, whose derivative is infinite.
    u[kBendingX] = select(some, sqrt(select(some, square, constant<S>(1))), zero);
    u[kBendingY] = zero;
  }
  return u;
}

/// Directions of the u_i (columns) in terms of the force that they belong to.
template <class Gauge>
inline SectionTangent<typename Gauge::Scalar> axes_of(
    const SectionForce<typename Gauge::Scalar>& z, const SectionForce<typename Gauge::Scalar>& u) {
  using S = typename Gauge::Scalar;
  SectionTangent<S> axes;
  for (std::size_t i = 0; i < kSectionAxes; ++i) axes(i, i) = sign(z[i]);
  if constexpr (Gauge::kRound) {
    const auto some = u[kBendingX] > constant<S>(0);
    const S length = select(some, u[kBendingX], constant<S>(1));
    axes(kBendingX, kBendingX) = select(some, z[kBendingX] / length, constant<S>(1));
    axes(kBendingY, kBendingX) = select(some, z[kBendingY] / length, constant<S>(0));
    axes(kBendingY, kBendingY) = constant<S>(0);
  }
  return axes;
}

/// phi in the orthant: 1 on the surface, proportional to the force.
template <class Gauge>
inline typename Gauge::Scalar orthant_gauge(const Gauge& gauge,
                                            const SectionForce<typename Gauge::Scalar>& u) {
  using S = typename Gauge::Scalar;
  S largest = gauge.facet(0, u).value;
  for (std::size_t k = 1; k < Gauge::kFacets; ++k) largest = max(largest, gauge.facet(k, u).value);
  const S square = constant<S>(2) * largest;
  const auto some = square > constant<S>(0);
  return select(some, sqrt(select(some, square, constant<S>(1))), constant<S>(0));
}

/// phi of a force over its caps.
template <class Gauge>
inline typename Gauge::Scalar gauge_value(const Gauge& gauge,
                                          const SectionForce<typename Gauge::Scalar>& z) {
  return orthant_gauge(gauge, orthant_of<Gauge>(z));
}

/// d phi/d z; at a kink, of one of the facets that meet there, and 0 by a component that is absent.
template <class Gauge>
inline SectionForce<typename Gauge::Scalar> gauge_gradient(
    const Gauge& gauge, const SectionForce<typename Gauge::Scalar>& z) {
  using S = typename Gauge::Scalar;
  const SectionForce<S> u = orthant_of<Gauge>(z);
  GaugeFacet<S> largest = gauge.facet(0, u);
  for (std::size_t k = 1; k < Gauge::kFacets; ++k) {
    const GaugeFacet<S> f = gauge.facet(k, u);
    const auto larger = f.value > largest.value;
    largest.value = select(larger, f.value, largest.value);
    for (std::size_t i = 0; i < kSectionAxes; ++i) {
      largest.gradient[i] = select(larger, f.gradient[i], largest.gradient[i]);
    }
  }
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    largest.gradient[i] = select(u[i] > constant<S>(0), largest.gradient[i], constant<S>(0));
  }
  const S phi = sqrt(constant<S>(2) * largest.value);
  return (constant<S>(1) / phi) * (axes_of<Gauge>(z, u) * largest.gradient);
}

}  // namespace plastica::law
