#include "plastica/law/fibre_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "plastica/law/shear_levers.hpp"
#include "plastica/model/section_kind.hpp"

namespace plastica::law {
namespace {

/// Integrals of width x position^k over an interval, k = 0 … 3.
using Moments = std::array<double, 4>;

struct Point {
  double position;
  double weight;
};

Moments operator-(const Moments& a, const Moments& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
}

/// The two Gauss points of an interval with these moments: with the central moments m2, m3 per
/// area the positions about the centroid solve t^2 - (m3/m2) t - m2 = 0.
std::array<Point, 2> gauss_points(const Moments& m) {
  const double centre = m[1] / m[0];
  const double m2 = m[2] / m[0] - centre * centre;
  const double m3 = m[3] / m[0] - 3.0 * centre * m[2] / m[0] + 2.0 * centre * centre * centre;
  const double skew = 0.5 * m3 / m2;
  const double root = std::sqrt(skew * skew + m2);
  const double low = skew - root;
  const double high = skew + root;
  return {Point{centre + low, m[0] * high / (high - low)},
          Point{centre + high, -m[0] * low / (high - low)}};
}

/// A constant width.
Moments strip(double width, double from, double to) {
  Moments m{};
  for (int k = 0; k < 4; ++k) {
    m[static_cast<std::size_t>(k)] =
        width * (std::pow(to, k + 1) - std::pow(from, k + 1)) / (k + 1);
  }
  return m;
}

/// The width of a disc, 2 sqrt(R^2 - y^2), up to y; its integrals in closed form.
Moments disc_up_to(double radius, double y) {
  const double sine = std::clamp(y / radius, -1.0, 1.0);
  const double angle = std::asin(sine);
  const double half = radius * std::sqrt(1.0 - sine * sine);
  const double r2 = radius * radius;
  const double h3 = half * half * half;
  return {r2 * (angle + sine * half / radius), -2.0 / 3.0 * h3,
          0.25 * r2 * r2 * (angle - 0.25 * std::sin(4.0 * angle)),
          -2.0 * (r2 * h3 / 3.0 - h3 * half * half / 5.0)};
}

/// Boundaries of intervals over a depth, symmetric, with one at 0 and at each of `edges`.
/// @param edges  from the axis on, rising; the last is half the depth
std::vector<double> boundaries(const std::vector<double>& edges, int intervals) {
  const int each = std::max(intervals / 2, 1);
  const double half = edges.back();
  const int zones = static_cast<int>(edges.size());
  std::vector<double> right{0.0};
  int dealt = 0;
  for (int zone = 0; zone < zones; ++zone) {
    const double from = zone == 0 ? 0.0 : edges[static_cast<std::size_t>(zone) - 1];
    const double to = edges[static_cast<std::size_t>(zone)];
    const int later = zones - 1 - zone;
    const int most = std::max(each - dealt - later, 1);
    const int count =
        later == 0 ? most
                   : std::clamp(static_cast<int>(std::lround(each * (to - from) / half)), 1, most);
    for (int i = 1; i <= count; ++i) right.push_back(from + (to - from) * i / count);
    dealt += count;
  }
  std::vector<double> all(right.rbegin(), right.rend() - 1);
  for (double& x : all) x = -x;
  all.insert(all.end(), right.begin(), right.end());
  return all;
}

/// Where blocks of a quarter end along y, or along x: rising, without 0.
std::vector<double> edges_of(const SectionQuarter& quarter, bool along_y) {
  std::vector<double> edges;
  for (const SectionBlock& block : quarter.blocks) {
    edges.push_back(along_y ? block.y_to : block.x_to);
    edges.push_back(along_y ? block.y_from : block.x_from);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  edges.erase(edges.begin());
  return edges;
}

bool contains(const SectionQuarter& quarter, double x, double y) {
  return std::any_of(quarter.blocks.begin(), quarter.blocks.end(), [&](const SectionBlock& block) {
    return std::fabs(x) > block.x_from && std::fabs(x) < block.x_to &&
           std::fabs(y) > block.y_from && std::fabs(y) < block.y_to;
  });
}

SectionQuarter quarter_of(const Section& s, bool about_x) {
  SectionQuarter quarter = section_kind(s).quarter(s).value();
  return about_x ? quarter : exchanged(std::move(quarter));
}

bool is_round(const Section& s) { return section_kind(s).round(); }

double hole_radius(const Section& s) { return section_kind(s).hole_radius(s); }

/// @param aside  see FibreLayout [m^2]
void add_layer(const Moments& m, double aside, FibreLayout& layout) {
  for (const Point& p : gauss_points(m)) {
    layout.depth.push_back(p.position);
    layout.area.push_back(p.weight);
    layout.aside.push_back(aside);
  }
}

/// Integral of x^2 over a disc up to y: (2/3) (R^2 - y^2)^(3/2) summed over y.
double disc_aside_up_to(double radius, double y) {
  const double angle = std::asin(std::clamp(y / radius, -1.0, 1.0));
  return std::pow(radius, 4) / 12.0 *
         (3.0 * angle + 2.0 * std::sin(2.0 * angle) + 0.25 * std::sin(4.0 * angle));
}

void add_round_layers(const Section& s, int intervals, FibreLayout& layout) {
  const double hole = hole_radius(s);
  std::vector<double> edges{s.radius};
  if (hole > 0.0) edges.insert(edges.begin(), hole);
  const std::vector<double> edge = boundaries(edges, intervals);
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    Moments m = disc_up_to(s.radius, edge[i + 1]) - disc_up_to(s.radius, edge[i]);
    double aside = disc_aside_up_to(s.radius, edge[i + 1]) - disc_aside_up_to(s.radius, edge[i]);
    if (hole > 0.0) {
      m = m - (disc_up_to(hole, edge[i + 1]) - disc_up_to(hole, edge[i]));
      aside -= disc_aside_up_to(hole, edge[i + 1]) - disc_aside_up_to(hole, edge[i]);
    }
    add_layer(m, aside / m[0], layout);
  }
}

/// Layers over the depth.
void add_layers(const Section& s, bool about_x, int intervals, FibreLayout& layout) {
  if (is_round(s)) {
    add_round_layers(s, intervals, layout);
    return;
  }
  const SectionQuarter quarter = quarter_of(s, about_x);
  const std::vector<double> edge = boundaries(edges_of(quarter, true), intervals);
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const double y = std::fabs(0.5 * (edge[i] + edge[i + 1]));
    double breadth = 0.0;
    double aside = 0.0;
    for (const SectionBlock& block : quarter.blocks) {
      if (y > block.y_from && y < block.y_to) {
        breadth += 2.0 * (block.x_to - block.x_from);
        aside += 2.0 / 3.0 * (std::pow(block.x_to, 3) - std::pow(block.x_from, 3));
      }
    }
    add_layer(strip(breadth, edge[i], edge[i + 1]), aside / breadth, layout);
  }
  for (const SectionSpot& spot : quarter.spots) {
    for (const double y : {-spot.y, spot.y}) {
      layout.depth.push_back(y);
      layout.area.push_back(2.0 * spot.area);
      layout.aside.push_back(spot.x * spot.x);
    }
  }
}

/// Gauss points of the blocks' cells, and the spots.
/// @param quarter_only  whether x, y > 0 stands for all, with four times the area
void add_grid(const Section& s, int intervals, bool quarter_only, FibreLayout& layout) {
  const SectionQuarter quarter = quarter_of(s, true);
  const std::vector<double> y = boundaries(edges_of(quarter, true), intervals);
  const std::vector<double> x = boundaries(edges_of(quarter, false), intervals);
  const double weight = quarter_only ? 4.0 : 1.0;
  const auto add = [&](double across, double depth, double area) {
    layout.depth.push_back(depth);
    layout.across.push_back(across);
    layout.area.push_back(weight * area);
  };
  for (std::size_t i = quarter_only ? y.size() / 2 : 0; i + 1 < y.size(); ++i) {
    for (std::size_t j = quarter_only ? x.size() / 2 : 0; j + 1 < x.size(); ++j) {
      if (!contains(quarter, 0.5 * (x[j] + x[j + 1]), 0.5 * (y[i] + y[i + 1]))) continue;
      for (const Point& up : gauss_points(strip(1.0, y[i], y[i + 1]))) {
        for (const Point& side : gauss_points(strip(1.0, x[j], x[j + 1]))) {
          add(side.position, up.position, up.weight * side.weight);
        }
      }
    }
  }
  for (const SectionSpot& spot : quarter.spots) {
    if (quarter_only) {
      add(spot.x, spot.y, spot.area);
      continue;
    }
    for (const double sx : {-1.0, 1.0}) {
      for (const double sy : {-1.0, 1.0}) add(sx * spot.x, sy * spot.y, spot.area);
    }
  }
}

/// Gauss points over the radius with the circumference as width.
std::vector<Point> rings_of(const Section& s, int intervals) {
  const double inner = hole_radius(s);
  std::vector<Point> rings;
  for (int i = 0; i < intervals; ++i) {
    const double from = inner + (s.radius - inner) * i / intervals;
    const double to = inner + (s.radius - inner) * (i + 1) / intervals;
    Moments m{};
    for (int k = 0; k < 4; ++k) {
      m[static_cast<std::size_t>(k)] =
          2.0 * std::numbers::pi * (std::pow(to, k + 2) - std::pow(from, k + 2)) / (k + 2);
    }
    for (const Point& p : gauss_points(m)) rings.push_back(p);
  }
  return rings;
}

/// A polar grid: the sums of cos^2 and sin^2 over evenly spaced angles are exact.
void add_polar(const Section& s, int intervals, FibreLayout& layout) {
  const int sectors = 4 * intervals;
  for (const Point& ring : rings_of(s, std::max(intervals / 2, 1))) {
    for (int i = 0; i < sectors; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.5) / sectors;
      layout.depth.push_back(ring.position * std::sin(angle));
      layout.across.push_back(ring.position * std::cos(angle));
      layout.area.push_back(ring.weight / sectors);
      layout.lever.push_back(ring.position);
    }
  }
}

void set_levers(const Section& s, const SectionProperties& p, FibreLayout& layout) {
  std::vector<double> elastic;
  elastic.reserve(layout.area.size());
  for (std::size_t i = 0; i < layout.area.size(); ++i) {
    elastic.push_back(section_kind(s).twist_shear(s, p, {layout.across[i], layout.depth[i]}));
  }
  layout.lever = shear_levers(layout.area, elastic,
                              {p.torsion_constant, p.torsion_modulus, p.plastic_torsion_modulus});
}

/// lever h with h = f - c_0 - c_1 lever/longest, such that sum A lever^2 h = 0 and sum A lever h =
/// 0.
std::vector<double> balanced(const FibreLayout& layout, const std::vector<double>& f) {
  const double longest = *std::max_element(layout.lever.begin(), layout.lever.end());
  // Moments of lever/longest: `sum[k]` of its power k + 1, and `rest[k]` with f.
  std::array<double, 3> sum{};
  std::array<double, 2> rest{};
  for (std::size_t i = 0; i < f.size(); ++i) {
    double power = layout.area[i];
    for (std::size_t k = 0; k < 3; ++k) {
      power *= layout.lever[i] / longest;
      sum[k] += power;
      if (k < 2) rest[k] += power * f[i];
    }
  }
  const double det = sum[0] * sum[2] - sum[1] * sum[1];
  // Where all levers are alike both conditions are one.
  const bool alike = det < 1e-9 * sum[0] * sum[2];
  const double c0 = alike ? rest[0] / sum[0] : (rest[0] * sum[2] - rest[1] * sum[1]) / det;
  const double c1 = alike ? 0.0 : (rest[1] * sum[0] - rest[0] * sum[1]) / det;
  std::vector<double> warp;
  warp.reserve(f.size());
  for (std::size_t i = 0; i < f.size(); ++i) {
    warp.push_back(layout.lever[i] * (f[i] - c0 - c1 * layout.lever[i] / longest));
  }
  return warp;
}

/// Cosine and sine of twice the angle of each fibre, seen in a section drawn to a square.
void set_warping(const Section& s, FibreLayout& layout) {
  const double width = is_round(s) ? 1.0 : s.width;
  const double height = is_round(s) ? 1.0 : s.height;
  std::vector<double> cosine;
  std::vector<double> sine;
  for (std::size_t i = 0; i < layout.area.size(); ++i) {
    const double x = layout.across[i] / width;
    const double y = layout.depth[i] / height;
    const double square = x * x + y * y;
    cosine.push_back((x * x - y * y) / square);
    sine.push_back(2.0 * x * y / square);
  }
  layout.warp = {balanced(layout, cosine), balanced(layout, sine)};
}

/// What twists: rings of a round section, a quarter of another, by symmetry.
void add_torsion(const Section& s, const SectionProperties& p, int intervals, FibreLayout& layout) {
  if (is_round(s)) {
    for (const Point& ring : rings_of(s, intervals)) {
      layout.lever.push_back(ring.position);
      layout.area.push_back(ring.weight);
    }
    return;
  }
  add_grid(s, intervals, true, layout);
  set_levers(s, p, layout);
  layout.depth.clear();
  layout.across.clear();
}

}  // namespace

int taken_fibres(const Section& section, FibrePlane plane, int fibres) {
  std::size_t parts = 1;
  if (is_round(section)) {
    const bool layers = plane == FibrePlane::AboutX || plane == FibrePlane::AboutY;
    if (layers && hole_radius(section) > 0.0) parts = 2;
  } else {
    const SectionQuarter quarter = quarter_of(section, true);
    const std::size_t deep = edges_of(quarter, true).size();
    const std::size_t wide = edges_of(quarter, false).size();
    parts = plane == FibrePlane::AboutX   ? deep
            : plane == FibrePlane::AboutY ? wide
                                          : std::min(deep, wide);
  }
  return 4 * std::max((fibres + 3) / 4, static_cast<int>(parts));
}

FibreLayout fibre_layout(const Section& section, const SectionProperties& properties,
                         FibrePlane plane, int fibres) {
  const int intervals = 2 * std::max((fibres + 3) / 4, 1);
  FibreLayout layout;
  layout.plane = plane;
  switch (plane) {
    case FibrePlane::AboutX:
    case FibrePlane::AboutY:
      add_layers(section, plane == FibrePlane::AboutX, intervals, layout);
      break;
    case FibrePlane::Torsion: add_torsion(section, properties, intervals, layout); break;
    case FibrePlane::Both:
      if (is_round(section)) {
        add_polar(section, intervals, layout);
      } else {
        add_grid(section, intervals, false, layout);
        set_levers(section, properties, layout);
      }
      set_warping(section, layout);
      break;
  }
  return layout;
}

}  // namespace plastica::law
