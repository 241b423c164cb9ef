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
enum class GaugeKind { Rectangle, Corner, Round, PlasticBlock, PlasticRound };

/// The numbers of a yield surface, from the section's geometry alone.
struct GaugeForm {
  GaugeKind kind = GaugeKind::Rectangle;
  /// Rectangle: `FirstYieldGauge` by its points; the first has xi = 1, eta = 0.
  std::array<double, kPerimeterPoints> xi{}, eta{}, tau_squared{};
  double axial = 1.0;  ///< e of `PlasticGauge`
};

/// Chooses and sets up the yield surface.
///
/// First yield:
/// - Circle and round tube: exact, (|n| + m)^2 + t^2 = 1 at the outer edge.
/// - Rectangle: exact but for the finite number of points of the perimeter, whose shear stresses
///   are Saint-Venant's; within 0.35 % for sides of 1:1 to 10:1 (measured against 400 points a
///   side). The points are chosen so that all gaps miss alike, and then moved out by half of it.
/// - `Conservative`, and a rectangular tube: the largest of both stresses taken at the corner,
///   (|n| + |m_x| + |m_y|)^2 + t^2 = 1. Exact for thin walls of even thickness, where the shear
///   stress is the same along a side; else safe, by up to 29 % as for a solid rectangle.
/// Fully plastic (see `PlasticGauge`), all safe; figures are along a ray of the surface:
/// - Bending alone: exact for rectangle, circle and round tube; a square box as well.
/// - One moment with axial force: exact for the rectangle, else safe by up to 1.6 % (circle), 6.5 %
///   (thin round tube), 11 % (box).
/// - Both moments with axial force: rectangle within 2 %, box 11 %; a fibre section is better
/// there.
GaugeForm gauge_form(const Section& section, YieldModel model, YieldCap cap, Formulas formulas);

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
    case GaugeKind::PlasticBlock: use(PlasticGauge<S, false>{constant<S>(form.axial)}); return;
    case GaugeKind::PlasticRound: use(PlasticGauge<S, true>{constant<S>(form.axial)}); return;
  }
}

}  // namespace plastica::law
