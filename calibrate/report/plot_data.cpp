#include "calibrate/report/plot_data.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate::report {
namespace {

constexpr std::size_t kMeanPoints = 200;

/// A curve as points in % and MPa.
std::vector<std::vector<double>> shown_points(const Curve& curve) {
  const Curve shown = thinned(curve);
  std::vector<std::vector<double>> points;
  points.reserve(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    points.push_back({100.0 * shown.strain[i], 1e-6 * shown.stress[i]});
  }
  return points;
}

struct Extent {
  double low = 0.0;
  double high = 0.0;
  double size() const { return high > low ? high - low : 1.0; }
};

Extent extent_of(const std::vector<double>& values) {
  Extent extent;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    extent.low = std::min(extent.low, value);
    extent.high = std::max(extent.high, value);
  }
  return extent;
}

/// Whether strain only grows, but for noise of a hundredth of its range.
bool grows(const Curve& curve) {
  double largest = curve.strain.front();
  const double noise = 0.01 * extent_of(curve.strain).size();
  for (const double strain : curve.strain) {
    if (strain < largest - noise) return false;
    largest = std::max(largest, strain);
  }
  return true;
}

/// Stress at a strain, linear between the first two samples that enclose it.
double stress_at(const Curve& curve, double strain, std::size_t& from) {
  while (from + 1 < curve.size() && curve.strain[from + 1] < strain) ++from;
  if (from + 1 >= curve.size()) return curve.stress.back();
  const double width = curve.strain[from + 1] - curve.strain[from];
  if (!(width > 0.0)) return curve.stress[from + 1];
  const double fraction = std::clamp((strain - curve.strain[from]) / width, 0.0, 1.0);
  return curve.stress[from] + fraction * (curve.stress[from + 1] - curve.stress[from]);
}

}  // namespace

std::string add_curve(PlotScript& script, const Curve& curve) {
  return add_curves(script, {&curve});
}

std::string add_curves(PlotScript& script, const std::vector<const Curve*>& curves) {
  std::vector<std::vector<std::vector<double>>> lists;
  lists.reserve(curves.size());
  for (const Curve* curve : curves) lists.push_back(shown_points(*curve));
  return script.add_lists(lists);
}

Curve thinned(const Curve& curve, std::size_t spots) {
  const Extent strains = extent_of(curve.strain);
  const Extent stresses = extent_of(curve.stress);
  const auto count = static_cast<double>(spots);
  Curve kept;
  double last_x = -1.0;
  double last_y = -1.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!std::isfinite(curve.strain[i]) || !std::isfinite(curve.stress[i])) continue;
    const double x = std::floor(count * (curve.strain[i] - strains.low) / strains.size());
    const double y = std::floor(count * (curve.stress[i] - stresses.low) / stresses.size());
    if (x == last_x && y == last_y && i + 1 < curve.size()) continue;
    last_x = x;
    last_y = y;
    kept.strain.push_back(curve.strain[i]);
    kept.stress.push_back(curve.stress[i]);
  }
  return kept;
}

Curve mean_curve(const std::vector<const Curve*>& curves) {
  if (curves.size() < 2) return {};
  double begin = curves.front()->strain.front();
  double end = curves.front()->strain.back();
  for (const Curve* curve : curves) {
    if (!grows(*curve)) return {};
    begin = std::max(begin, curve->strain.front());
    end = std::min(end, *std::max_element(curve->strain.begin(), curve->strain.end()));
  }
  if (begin >= end) return {};
  std::vector<std::size_t> from(curves.size(), 0);
  Curve mean;
  for (std::size_t k = 0; k < kMeanPoints; ++k) {
    // Denser at the start, where the curves are steep.
    const double fraction = static_cast<double>(k) / static_cast<double>(kMeanPoints - 1);
    const double strain = begin + (end - begin) * fraction * fraction;
    double sum = 0.0;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      sum += stress_at(*curves[c], strain, from[c]);
    }
    mean.strain.push_back(strain);
    mean.stress.push_back(sum / static_cast<double>(curves.size()));
  }
  return mean;
}

}  // namespace plastica::calibrate::report
