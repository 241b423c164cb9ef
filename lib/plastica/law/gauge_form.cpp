#include "plastica/law/gauge_form.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "plastica/model/section_kind.hpp"
#include "plastica/model/torsion.hpp"

namespace plastica::law {
namespace {

using std::numbers::pi;

/// A point of half a side: distance from its middle over half its length, and shear stress over
/// the section's largest.
struct SidePoint {
  double position;
  double shear;
};

constexpr std::size_t kCandidates = 100;

/// How much less the points `from` and `to` alone find than all between them would, at worst.
///
/// On a side whose bending has its full lever a >= y, the gauge is the largest over angles and
/// points of a cos + y cos position + t sin shear, linear in a point. A point between misses most
/// where the two ends weigh alike, with the line through them as normal, and where a = y.
double gap(const std::vector<SidePoint>& side, std::size_t from, std::size_t to) {
  const double along = side[from].shear - side[to].shear;
  const double across = side[to].position - side[from].position;
  const auto weight = [&](const SidePoint& p) {
    return along * (1.0 + p.position) + across * p.shear;
  };
  double worst = 0.0;
  for (std::size_t i = from + 1; i < to; ++i) {
    worst = std::max(worst, weight(side[i]) / weight(side[from]) - 1.0);
  }
  return worst;
}

/// Points from the middle to the corner of which no two neighbours miss more than `tolerance`.
std::vector<std::size_t> march(const std::vector<SidePoint>& side, double tolerance) {
  std::vector<std::size_t> chosen{0};
  const std::size_t corner = side.size() - 1;
  while (chosen.back() < corner) {
    std::size_t next = chosen.back() + 1;
    while (next < corner && gap(side, chosen.back(), next + 1) <= tolerance) ++next;
    chosen.push_back(next);
  }
  return chosen;
}

/// The `kPointsOfSide` best points of a side, without the corner, moved out by half of what they
/// miss.
std::array<SidePoint, kPointsOfSide> side_points(double ratio, bool long_side) {
  std::vector<SidePoint> side;
  for (std::size_t i = 0; i <= kCandidates; ++i) {
    const double position = static_cast<double>(i) / kCandidates;
    side.push_back({position, saint_venant_perimeter_stress(ratio, long_side, position)});
  }
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (march(side, middle).size() <= kPointsOfSide + 1 ? high : low) = middle;
  }
  const std::vector<std::size_t> chosen = march(side, high);
  std::array<SidePoint, kPointsOfSide> points;
  points.fill(side.front());
  for (std::size_t k = 1; k + 1 < chosen.size(); ++k) {
    const SidePoint& p = side[chosen[k]];
    const double out = 1.0 + 0.5 * high;
    points[k] = {std::min(out * p.position, 1.0), std::min(out * p.shear, side.front().shear)};
  }
  return points;
}

/// They depend on the ratio alone, which cases of a sweep and trials of a fit have in common; to
/// sum up a hundred stresses takes longer than to bend a beam. Kept is what was found last.
const std::array<SidePoint, kPointsOfSide>& kept_side_points(double ratio, bool long_side) {
  struct Found {
    double ratio = 0.0;
    std::array<SidePoint, kPointsOfSide> points{};
  };
  thread_local std::array<Found, 2> last;
  Found& found = last[long_side ? 1 : 0];
  if (found.ratio != ratio) found = {ratio, side_points(ratio, long_side)};
  return found.points;
}

void set_rectangle(const Section& section, GaugeForm& form) {
  const double ratio =
      std::max(section.width, section.height) / std::min(section.width, section.height);
  // Bending about x has its full lever on the sides along x, of length `width`.
  const bool x_has_long_sides = section.width >= section.height;
  const auto& of_x = kept_side_points(ratio, x_has_long_sides);
  const auto& of_y = kept_side_points(ratio, !x_has_long_sides);
  for (std::size_t k = 0; k < kPointsOfSide; ++k) {
    form.xi[k] = 1.0;
    form.eta[k] = of_x[k].position;
    form.tau_squared[k] = of_x[k].shear * of_x[k].shear;
    const std::size_t j = kPointsOfSide + k;
    form.xi[j] = of_y[k].position;
    form.eta[j] = 1.0;
    form.tau_squared[j] = of_y[k].shear * of_y[k].shear;
  }
  form.xi.back() = form.eta.back() = 1.0;
  form.tau_squared.back() = 0.0;
}

using Curve = std::vector<std::array<double, 2>>;  ///< (n, m), from n = 0 to 1, without both

/// Largest e for which (1 - n)(1 + e n) is nowhere above the curve m(n) of `points`.
double largest_axial(const Curve& points) {
  double e = 1.0;
  for (const auto& [n, m] : points) {
    if (n > 1e-3 && n < 1.0 - 1e-3) e = std::min(e, (m / (1.0 - n) - 1.0) / n);
  }
  return e;
}

/// Neutral axis at R sin(a): m = (R^3 cos^3 a - c(r))/(R^3 - r^3), with the chord of the hole cut
/// out; n from the area between the neutral axis and its mirror image. More points near the edge,
/// where both change fast.
Curve round_curve(double R, double r) {
  Curve points;
  const auto half_area = [](double radius, double y) {  // between the centre and y
    const double s = std::min(y / radius, 1.0);
    return radius * radius * (std::asin(s) + s * std::sqrt(1.0 - s * s));
  };
  const auto chord_cubed = [](double radius, double y) {
    return std::pow(std::max(radius * radius - y * y, 0.0), 1.5);
  };
  for (int i = 1; i < 400; ++i) {
    const double y = R * std::sin(0.5 * pi * i / 400.0);
    const double area = pi * (R * R - r * r);
    const double inner = r > 0.0 ? 2.0 * half_area(r, y) : 0.0;
    points.push_back({(2.0 * half_area(R, y) - inner) / area,
                      (chord_cubed(R, y) - chord_cubed(r, y)) / (R * R * R - r * r * r)});
  }
  return points;
}

/// The same of blocks that bend about x: what lies between the neutral axis and its mirror image
/// carries the axial force, the rest the moment.
Curve quarter_curve(const SectionQuarter& quarter) {
  const auto edge_of = [](double so_far, const SectionBlock& block) {
    return std::max(so_far, block.y_to);
  };
  const double half = std::accumulate(quarter.blocks.begin(), quarter.blocks.end(), 0.0, edge_of);
  // Up to y: area, and its first moment.
  const auto up_to = [&](double y) {
    std::array<double, 2> sum{};
    for (const SectionBlock& block : quarter.blocks) {
      const double to = std::clamp(y, block.y_from, block.y_to);
      const double breadth = block.x_to - block.x_from;
      sum[0] += breadth * (to - block.y_from);
      sum[1] += 0.5 * breadth * (to * to - block.y_from * block.y_from);
    }
    for (const SectionSpot& spot : quarter.spots) {
      if (spot.y > y) continue;
      sum[0] += spot.area;
      sum[1] += spot.area * spot.y;
    }
    return sum;
  };
  const auto whole = up_to(half);
  Curve points;
  for (int i = 1; i < 400; ++i) {
    const auto inner = up_to(half * i / 400.0);
    points.push_back({inner[0] / whole[0], 1.0 - inner[1] / whole[1]});
  }
  return points;
}

/// R(p) of `PlasticCurveGauge` for a curve: with value and slope of its ends, where m = 1 with no
/// slope and m = k (1 - n), so that R(0) = R(1) = 1, R'(0) = -1, R'(1) = 1 - 1/k; between them by
/// least squares of R over m, as errors of R are of m. Straight stretches of a curve (flanges) have
/// R'' = 0, which a polynomial would undershoot: where it does, R'' is held at 0 by weights.
std::array<double, kRadiusTerms> radius_terms(const Curve& curve) {
  constexpr Eigen::Index kFree = kRadiusTerms - 4;
  constexpr int kRounds = 20;
  constexpr int kChecks = 200;
  const auto [n_end, m_end] = curve.back();
  const double end_slope = 1.0 - (1.0 - n_end) / m_end;
  // Of p^2 (1 - p)^2 p^k, as terms of p.
  const std::array<double, 3> bump{1.0, -2.0, 1.0};
  std::array<double, kRadiusTerms> terms{};
  // Hermite's cubic with R(0) = R(1) = 1: 1 - (p - 2 p^2 + p^3) + end_slope (p^3 - p^2).
  terms[0] = 1.0;
  terms[1] = -1.0;
  terms[2] = 2.0 - end_slope;
  terms[3] = end_slope - 1.0;
  const std::array<double, kRadiusTerms> cubic = terms;
  const auto value = [](const auto& of, double p) {
    double sum = 0.0;
    for (std::size_t k = of.size(); k-- > 0;) sum = sum * p + of[k];
    return sum;
  };
  const auto second = [](double exponent, double p) {
    return exponent < 2.0 ? 0.0 : exponent * (exponent - 1.0) * std::pow(p, exponent - 2.0);
  };
  const auto curvature = [&](const auto& of, double p) {
    double sum = 0.0;
    for (std::size_t k = 2; k < of.size(); ++k) sum += of[k] * second(static_cast<double>(k), p);
    return sum;
  };
  const auto points = static_cast<Eigen::Index>(curve.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(points + kChecks, kFree);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(points + kChecks);
  for (Eigen::Index i = 0; i < points; ++i) {
    const auto [n, m] = curve[static_cast<std::size_t>(i)];
    const double p = n / (m + n);
    const double weight = 1.0 / std::max(m, 0.02);
    for (Eigen::Index k = 0; k < kFree; ++k) {
      a(i, k) = weight * p * p * (1.0 - p) * (1.0 - p) * std::pow(p, static_cast<double>(k));
    }
    b(i) = weight * (1.0 / (m + n) - value(cubic, p));
  }
  std::array<double, kChecks> held{};
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd found = a.colPivHouseholderQr().solve(b);
    terms = cubic;
    for (Eigen::Index k = 0; k < kFree; ++k) {
      for (std::size_t j = 0; j < bump.size(); ++j) {
        terms[static_cast<std::size_t>(k) + 2 + j] += found(k) * bump[j];
      }
    }
    bool convex = true;
    for (int c = 0; c < kChecks; ++c) {
      const double p = (c + 0.5) / kChecks;
      if (curvature(terms, p) >= 0.0) continue;
      convex = false;
      double& weight = held[static_cast<std::size_t>(c)];
      weight = weight == 0.0 ? 0.02 : 2.0 * weight;
      const Eigen::Index row = points + c;
      for (Eigen::Index k = 0; k < kFree; ++k) {
        double sum = 0.0;
        for (std::size_t j = 0; j < bump.size(); ++j) {
          sum += bump[j] * second(static_cast<double>(k) + 2.0 + static_cast<double>(j), p);
        }
        a(row, k) = weight * sum;
      }
      b(row) = weight * (0.01 - curvature(cubic, p));
    }
    if (convex) break;
  }
  return terms;
}

/// The curve of a section that bends about one axis, or is round.
Curve plastic_curve(const Section& s, GaugePlane plane) {
  const SectionKind& kind = section_kind(s);
  if (kind.round()) return round_curve(s.radius, kind.hole_radius(s));
  SectionQuarter quarter = kind.quarter(s).value();
  return quarter_curve(plane == GaugePlane::AboutY ? exchanged(std::move(quarter)) : quarter);
}

/// e of the section's fully plastic surface.
double plastic_axial(const Section& s) {
  return std::min(largest_axial(plastic_curve(s, GaugePlane::AboutX)),
                  largest_axial(plastic_curve(s, GaugePlane::AboutY)));
}

void set_plastic(const Section& section, GaugePlane plane, GaugeForm& form) {
  const SectionKind& kind = section_kind(section);
  if (kind.edge() == SectionEdge::Rectangle) {
    form.kind = GaugeKind::PlasticBlock;
    form.axial = 1.0;
  } else if (!kind.has_fibres()) {
    form.kind = GaugeKind::Corner;
  } else if (kind.round() || plane != GaugePlane::Both) {
    form.kind = GaugeKind::PlasticCurve;
    form.radius = radius_terms(plastic_curve(section, plane));
  } else if (kind.holds_plastic_block()) {
    form.kind = GaugeKind::PlasticBlock;
    form.axial = plastic_axial(section);
  } else {
    form.kind = GaugeKind::Corner;
  }
}

}  // namespace

GaugeForm gauge_form(const Section& section, YieldModel model, YieldCap cap, Formulas formulas,
                     GaugePlane plane) {
  GaugeForm form;
  if (model == YieldModel::Conservative) {
    form.kind = GaugeKind::Corner;
    return form;
  }
  if (cap == YieldCap::FullyPlastic && formulas == Formulas::Mechanics) {
    set_plastic(section, plane, form);
    return form;
  }
  switch (section_kind(section).edge()) {
    case SectionEdge::Round: form.kind = GaugeKind::Round; break;
    case SectionEdge::Walls: form.kind = GaugeKind::Corner; break;
    case SectionEdge::Rectangle: set_rectangle(section, form); break;
  }
  return form;
}

double moment_left(const Section& section, YieldCap cap, Formulas formulas, double n,
                   GaugePlane plane) {
  const bool plastic = cap == YieldCap::FullyPlastic && formulas == Formulas::Mechanics;
  if (n >= 1.0) return 0.0;
  if (!plastic) return 1.0 - n;
  const SectionKind& kind = section_kind(section);
  if (kind.edge() == SectionEdge::Rectangle) return 1.0 - n * n;
  if (!kind.has_fibres()) return 1.0 - n;
  std::array<double, 2> before{0.0, 1.0};
  for (const auto& point : plastic_curve(section, plane)) {
    if (point[0] >= n) {
      const double part = (n - before[0]) / (point[0] - before[0]);
      return before[1] + part * (point[1] - before[1]);
    }
    before = point;
  }
  return before[1] * (1.0 - n) / (1.0 - before[0]);
}

NeutralAxis neutral_axis(const Section& section, const SectionProperties& properties,
                         const GaugeForm& gauge, GaugePlane plane, double lever) {
  NeutralAxis axis;
  switch (gauge.kind) {
    case GaugeKind::Rectangle:
    case GaugeKind::Corner:
    case GaugeKind::Round: axis.at_edge = lever; break;
    case GaugeKind::PlasticBlock:  // m = (1 - n)(1 + e n)
      axis.at_edge = (1.0 - gauge.axial) * lever;
      axis.rises = 2.0 * gauge.axial * lever;
      break;
    case GaugeKind::PlasticCurve: break;
  }
  const bool about_y = plane == GaugePlane::AboutY;
  if (!section_kind(section).has_fibres()) {
    axis.moves = about_y ? properties.outer_distance_y : properties.outer_distance_x;
    return axis;
  }
  // m = 1 - c n^2 beside n = 0, and dy/dn = 2 c M_p/N_p.
  constexpr double kSmall = 0.05;
  const double lost =
      1.0 - moment_left(section, YieldCap::FullyPlastic, Formulas::Mechanics, kSmall, plane);
  const double modulus =
      about_y ? properties.plastic_section_modulus_y : properties.plastic_section_modulus_x;
  axis.moves = 2.0 * lost / (kSmall * kSmall) * modulus / properties.area;
  return axis;
}

double axial_share(const GaugeForm& gauge, SectionForce<double> over_caps) {
  over_caps[kTorsion] = 0.0;
  double radius = 0.0;
  with_gauge<double>(gauge, [&](const auto& surface) { radius = gauge_value(surface, over_caps); });
  return radius > 0.0 ? std::abs(over_caps[kAxial]) / radius : 0.0;
}

}  // namespace plastica::law
