#include "sweeps/advise/grading.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plastica/model/beam_axis.hpp"

namespace plastica::sweeps {
namespace {

/// Of the mean change of the curvature: so much counts where it does not change. The cube root of
/// 0.03 is 0.31.
constexpr double kFloor = 0.03;

/// The curvature at each joint [rad per length of the beam].
std::vector<double> curvature_of(const Scene& scene, const std::vector<double>& bent,
                                 const std::vector<double>& ends) {
  const std::size_t last = ends.size() - 1;
  std::vector<double> curvature(ends.size());
  for (std::size_t i = 1; i < last; ++i)
    curvature[i] = bent[i] / (0.5 * (ends[i + 1] - ends[i - 1]));
  // What a hinge turns by bends nothing.
  for (const Support& one : scene.supports) {
    if (one.kind != SupportKind::Hinge) continue;
    const auto at = segment_end_at(one.at, ends);
    if (!at || *at < 2 || *at + 2 > static_cast<int>(last)) continue;
    const auto i = static_cast<std::size_t>(*at);
    curvature[i] = 0.5 * (curvature[i - 1] + curvature[i + 1]);
  }
  // How much of a length an end's joint stands for is a rule of its own: on as within.
  curvature[0] = 2.0 * curvature[1] - curvature[2];
  curvature[last] = 2.0 * curvature[last - 1] - curvature[last - 2];
  return curvature;
}

/// How many segments come before each end: its cumulative density, 0 … 1.
std::vector<double> cumulative_density(const std::vector<double>& curvature,
                                       const std::vector<double>& ends) {
  const std::size_t count = ends.size() - 1;
  std::vector<double> change(count);
  for (std::size_t i = 0; i < count; ++i) {
    change[i] = std::abs(curvature[i + 1] - curvature[i]) / (ends[i + 1] - ends[i]);
  }
  std::vector<double> smooth(count);
  double mean = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double before = change[i > 0 ? i - 1 : i];
    const double after = change[i + 1 < count ? i + 1 : i];
    smooth[i] = (before + change[i] + after) / 3.0;
    mean += smooth[i] * (ends[i + 1] - ends[i]);
  }
  std::vector<double> sum(ends.size());
  if (!(mean > 0.0) || !std::isfinite(mean)) return {};
  for (std::size_t i = 0; i < count; ++i) {
    sum[i + 1] = sum[i] + std::cbrt(smooth[i] / mean + kFloor) * (ends[i + 1] - ends[i]);
  }
  for (double& each : sum) each /= sum[count];
  return sum;
}

/// Where a line through points is at an x; both rise.
double on_line(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto above = std::upper_bound(xs.begin() + 1, xs.end() - 1, x);
  const auto k = static_cast<std::size_t>(above - xs.begin());
  const double part = (x - xs[k - 1]) / (xs[k] - xs[k - 1]);
  return ys[k - 1] + part * (ys[k] - ys[k - 1]);
}

/// Where segments are to end: where the scene needs it, and where it looks. What a probe within a
/// segment sees goes with the place in it, in a beam with each segment divided, too.
std::vector<double> wanted_ends(const Scene& scene, const std::vector<double>& ends) {
  constexpr double kSamePlace = 1e-9;
  std::vector<double> wanted = needed_ends(scene);
  for (const Probe& probe : scene.probes) wanted.push_back(fraction_of(probe.at, ends));
  std::sort(wanted.begin(), wanted.end());
  const auto same = [](double a, double b) { return b - a <= kSamePlace; };
  wanted.erase(std::unique(wanted.begin(), wanted.end(), same), wanted.end());
  wanted.back() = 1.0;
  return wanted;
}

/// How many segments each stretch between wanted ends gets: at least one, else by its part.
std::vector<int> dealt(const std::vector<double>& density_at, int segments) {
  const std::size_t stretches = density_at.size() - 1;
  const auto wanted = [&](std::size_t j) { return (density_at[j + 1] - density_at[j]) * segments; };
  std::vector<int> counts(stretches, 1);
  for (int left = segments - static_cast<int>(stretches); left > 0; --left) {
    std::size_t most = 0;  // whose segments are the longest for their density
    for (std::size_t j = 1; j < stretches; ++j) {
      if (wanted(j) / counts[j] > wanted(most) / counts[most]) most = j;
    }
    ++counts[most];
  }
  return counts;
}

}  // namespace

std::vector<double> graded_fractions(const Scene& scene, const std::vector<double>& bent,
                                     int segments) {
  const std::vector<double> ends = segment_ends(scene);
  if (ends.size() < 4 || ends.size() != bent.size()) return {};
  const std::vector<double> wanted = wanted_ends(scene, ends);
  if (segments + 1 < static_cast<int>(wanted.size())) return {};
  const std::vector<double> sum = cumulative_density(curvature_of(scene, bent, ends), ends);
  if (sum.empty()) return {};
  std::vector<double> density_at;
  for (const double place : wanted) density_at.push_back(on_line(ends, sum, place));
  const std::vector<int> counts = dealt(density_at, segments);
  // Ends with few digits, for who reads them; a thousandth of a segment does not matter.
  const double digits = std::pow(10.0, 3.0 + std::ceil(std::log10(segments)));
  std::vector<double> fractions;
  double before = 0.0;
  for (std::size_t j = 0; j + 1 < wanted.size(); ++j) {
    for (int i = 1; i <= counts[j]; ++i) {
      const double part = static_cast<double>(i) / counts[j];
      const double at = on_line(sum, ends, std::lerp(density_at[j], density_at[j + 1], part));
      const double end = i == counts[j] ? wanted[j + 1] : std::round(at * digits) / digits;
      if (!(end > before)) return {};
      fractions.push_back(end - before);
      before = end;
    }
  }
  return fractions;
}

std::vector<double> divided_evenly(const std::vector<double>& fractions, int parts) {
  std::vector<double> all;
  all.reserve(fractions.size() * static_cast<std::size_t>(parts));
  for (const double fraction : fractions) {
    all.insert(all.end(), static_cast<std::size_t>(parts), fraction / parts);
  }
  return all;
}

}  // namespace plastica::sweeps
