#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/gauge.hpp"
#include "plastica/model/rules.hpp"
#include "plastica/model/section.hpp"

namespace plastica::law {

/// Points of a rectangle's perimeter at which its first yield is looked for: six on half of each
/// side and the corner.
inline constexpr std::size_t kPointsOfSide = 6;
inline constexpr std::size_t kPerimeterPoints = 2 * kPointsOfSide + 1;

/// Which yield surface a section has.
enum class GaugeKind { Rectangle, Corner, Round, PlasticBlock, PlasticCurve };

/// What a level's sections bend about.
enum class GaugePlane { AboutX, AboutY, Both };

/// The numbers of a yield surface, from the section's geometry alone.
struct GaugeForm {
  GaugeKind kind = GaugeKind::Rectangle;
  /// Rectangle: `FirstYieldGauge` by its points; the first has xi = 1, eta = 0.
  std::array<double, kPerimeterPoints> xi{}, eta{}, tau_squared{};
  double axial = 1.0;                         ///< e of `PlasticGauge`
  std::array<double, kRadiusTerms> radius{};  ///< of `PlasticCurveGauge`
};

/// Chooses and sets up the yield surface.
///
/// First yield:
/// - Circle and round tube: exact, (|n| + m)^2 + t^2 = 1 at the outer edge.
/// - Rectangle: exact but for the finite number of points of the perimeter, whose shear stresses
///   are Saint-Venant's; within 0.35 % for sides of 1:1 to 10:1 (measured against 400 points a
///   side). The points are chosen so that all gaps miss alike, and then moved out by half of it.
/// - `Conservative`, and sections of walls: the largest of both stresses taken at the corner,
///   (|n| + |m_x| + |m_y|)^2 + t^2 = 1. Exact for tubes with thin walls of even thickness, where
///   the shear stress is the same along a side; else safe, by up to 29 % as for a solid rectangle.
/// Fully plastic (`PlasticGauge`; round sections, and boxes in a plane, `PlasticCurveGauge`):
/// - Bending alone: exact for rectangle, circle and round tube; a square box as well.
/// - One moment with axial force: exact for the rectangle. For round sections the moment is within
///   0.2 % of the exact one for n = 0 … 0.95, for boxes in a plane within 1 %.
/// - In space, both moments with axial force, along a ray of the surface: rectangle within 2 %,
/// safe;
///   box safe by up to 11 %, one moment with axial force, too; a fibre section is better there.
/// - In space, I-sections, and everywhere sections that are given by their numbers: the straight
///   surface through what each carries alone, |n| + |m_x| + |m_y| = 1 without torsion. Safe, as the
///   true one is convex; for an I-section by up to 24 % in both moments (m_x^2 + m_y = 1).
/// @param plane  of a level that bends in one plane, which it is
GaugeForm gauge_form(const Section& section, YieldModel model, YieldCap cap, Formulas formulas,
                     GaugePlane plane = GaugePlane::Both);

/// The moment that a section carries beside an axial force n = |N|/N_p, over that without: 1 - n at
/// first yield, fully plastic the section's own (of several that about x). Not below 0.
double moment_left(const Section& section, YieldCap cap, Formulas formulas, double n,
                   GaugePlane plane = GaugePlane::Both);

/// What of the elongation of a section that bends is its neutral axis' doing.
///
/// Of a fully plastic section under n that bends by the curvature k, the neutral axis is off the
/// middle by y, so that it grows longer by k y, y = -dM/dN along the section's own curve M(N): for
/// a rectangle n h/2, of any section proportional to n where n is small. A surface with an edge at
/// n = 0 lengthens the section by as much beside the least force as beside a large one: that at
/// first yield by k W/A, a sixth of the depth of a rectangle. What is more than k y is the edge's.
struct NeutralAxis {
  double moves = 0.0;    ///< dy/dn at n = 0 [m]
  double at_edge = 0.0;  ///< -dM/dN of the surface at n = 0 [m]; 0: it has no edge there
  double rises = 0.0;    ///< what it grows by with n [m]

  /// k y over the elongation of the surface, at most 1.
  /// @param n  axial force over the one that yields along the force's own direction
  double fraction(double n) const {
    const double flows = at_edge + rises * n;
    return at_edge > 0.0 && moves * n < flows ? moves * n / flows : 1.0;
  }
};

/// A section that is given by its numbers is taken to be as broad everywhere: n h/2.
/// @param plane  AboutX or AboutY
/// @param lever  yield moment over the axial force at yield, as the surface has them [m]
NeutralAxis neutral_axis(const Section& section, const SectionProperties& properties,
                         const GaugeForm& gauge, GaugePlane plane, double lever);

/// Axial force over that at yield, of one that is as far along the direction of the given forces
/// that they yield without their torque [1]; 0 without bending moment and axial force.
double axial_share(const GaugeForm& gauge, SectionForce<double> over_caps);

/// Calls `use(gauge)` with the yield surface as a type of its own.
template <class S, class Use>
inline void with_gauge(const GaugeForm& form, Use&& use) {
  const auto lift = []<std::size_t N>(const std::array<double, N>& plain) {
    std::array<S, N> numbers;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = constant<S>(plain[i]);
    return numbers;
  };
  const S zero = constant<S>(0);
  const S one = constant<S>(1);
  switch (form.kind) {
    case GaugeKind::Rectangle:
      use(FirstYieldGauge<S, kPerimeterPoints, false>{lift(form.xi), lift(form.eta),
                                                      lift(form.tau_squared)});
      return;
    case GaugeKind::Corner: use(FirstYieldGauge<S, 1, false>{{one}, {one}, {one}}); return;
    case GaugeKind::Round: use(FirstYieldGauge<S, 1, true>{{one}, {zero}, {one}}); return;
    case GaugeKind::PlasticBlock: use(PlasticGauge<S>{constant<S>(form.axial)}); return;
    case GaugeKind::PlasticCurve: use(PlasticCurveGauge<S>{lift(form.radius)}); return;
  }
}

}  // namespace plastica::law
