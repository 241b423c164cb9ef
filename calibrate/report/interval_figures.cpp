#include "calibrate/report/interval_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::kBlue;
using plastica::report::kGrey;
using plastica::report::kVermillion;
using plastica::report::Stroke;
using Points = std::vector<std::vector<double>>;

/// How far above the threshold a profile is shown.
constexpr double kRoom = 1.6;
/// Of a value, what the numbers along an axis still tell apart.
constexpr double kDigits = 1e-5;

/// The profile between its points: the root of the rise, with the sign of the side, as a straight
/// line, so that a parabola is one.
Points curve_of(const LikelihoodProfile& profile, double best, double scale) {
  constexpr int kBetween = 20;
  const auto root = [&](std::size_t i) {
    return std::copysign(std::sqrt(std::max(profile.rise[i], 0.0)), profile.value[i] - best);
  };
  Points points;
  for (std::size_t i = 0; i + 1 < profile.value.size(); ++i) {
    for (int k = 0; k <= kBetween; ++k) {
      const double fraction = static_cast<double>(k) / kBetween;
      const double r = root(i) + fraction * (root(i + 1) - root(i));
      const double value = profile.value[i] + fraction * (profile.value[i + 1] - profile.value[i]);
      if (r * r <= kRoom * profile.threshold) points.push_back({value / scale, r * r});
    }
  }
  return points;
}

FigurePanel profile_panel(const ShownParameter& p, const LikelihoodProfile& profile) {
  const DisplayUnit unit = report::display_unit(p);
  FigurePanel panel;
  panel.title = fmt::format("{} [{}]", short_name(p.path), unit.name);
  panel.y_label = "rise of the least cost";
  panel.y_range = {0.0, kRoom * profile.threshold};
  panel.curves.push_back(
      {curve_of(profile, p.value, unit.scale), "least cost", kBlue, Stroke::Line});
  Points met;
  double low = p.value, high = p.value;
  for (std::size_t i = 0; i < profile.value.size(); ++i) {
    if (profile.rise[i] > kRoom * profile.threshold) continue;
    met.push_back({profile.value[i] / unit.scale, profile.rise[i]});
    low = std::min(low, profile.value[i]);
    high = std::max(high, profile.value[i]);
  }
  for (const double end : {profile.low, profile.high}) {
    if (!std::isfinite(end)) continue;
    low = std::min(low, end);
    high = std::max(high, end);
  }
  panel.curves.push_back({std::move(met), "searched", kBlue, Stroke::Points, 7});
  if (std::isfinite(p.noise_error) && p.noise_error > 0.0) {
    Points parabola;
    for (int k = -60; k <= 60; ++k) {
      const double z = std::sqrt(kRoom * profile.threshold) * k / 60.0;
      parabola.push_back({(p.value + z * p.noise_error) / unit.scale, z * z});
      low = std::min(low, p.value + z * p.noise_error);
      high = std::max(high, p.value + z * p.noise_error);
    }
    panel.curves.push_back(
        {std::move(parabola), "parabola of the covariance", kVermillion, Stroke::Line, 7, 1});
  }
  // What exact data leave is narrower than the digits of a picture: it is a spike there.
  const double room = std::max(0.04 * (high - low), kDigits * std::fabs(high));
  panel.x_range = {(low - room) / unit.scale, (high + room) / unit.scale};
  panel.curves.push_back(
      {{{panel.x_range[0], profile.threshold}, {panel.x_range[1], profile.threshold}},
       "threshold",
       kGrey,
       Stroke::Line});
  if (profile.low_end == ProfileEnd::Crossed) panel.marks.push_back(profile.low / unit.scale);
  if (profile.high_end == ProfileEnd::Crossed) panel.marks.push_back(profile.high / unit.scale);
  if (!panel.marks.empty()) {
    // The points are those of the noise alone.
    panel.mark_name = p.sampling_error > 0.0 ? "ends of the interval, of a break with its sampling"
                                             : "ends of the interval";
  }
  return panel;
}

/// A column of a bootstrap.
std::vector<double> column_of(const BootstrapResult& bootstrap, std::size_t i, std::size_t n) {
  std::vector<double> values;
  for (std::size_t row = 0; row + n <= bootstrap.values.size(); row += n) {
    values.push_back(bootstrap.values[row + i]);
  }
  return values;
}

/// Steps of a histogram: how many values lie in each of equal intervals.
Points histogram_of(const std::vector<double>& values, double& width) {
  const auto [low, high] = std::ranges::minmax(values);
  const auto bins = static_cast<std::size_t>(std::clamp(2.0 * std::cbrt(values.size()), 8.0, 40.0));
  width = (high - low) / static_cast<double>(bins);
  if (!(width > 0.0)) return {{low, 0.0}, {low, static_cast<double>(values.size())}};
  std::vector<double> counts(bins, 0.0);
  for (const double v : values) {
    counts[std::min(static_cast<std::size_t>((v - low) / width), bins - 1)] += 1.0;
  }
  Points steps{{low, 0.0}};
  for (std::size_t k = 0; k < bins; ++k) {
    steps.push_back({low + static_cast<double>(k) * width, counts[k]});
    steps.push_back({low + static_cast<double>(k + 1) * width, counts[k]});
  }
  steps.push_back({high, 0.0});
  return steps;
}

FigurePanel histogram_panel(const ShownParameter& p, const BootstrapInterval& interval,
                            const std::vector<double>& values) {
  const DisplayUnit unit = report::display_unit(p);
  FigurePanel panel;
  panel.title = fmt::format("{} [{}]", short_name(p.path), unit.name);
  panel.y_label = "resamples";
  double width = 0.0;
  Points steps = histogram_of(values, width);
  for (auto& point : steps) point[0] /= unit.scale;
  panel.curves.push_back({std::move(steps), "resamples", kBlue, Stroke::Line});
  if (std::isfinite(p.scatter_error) && p.scatter_error > 0.0) {
    Points normal;
    const double height = static_cast<double>(values.size()) * width /
                          (p.scatter_error * std::sqrt(2.0 * std::numbers::pi));
    for (int k = -60; k <= 60; ++k) {
      const double z = 3.2 * k / 60.0;
      normal.push_back(
          {(p.value + z * p.scatter_error) / unit.scale, height * std::exp(-0.5 * z * z)});
    }
    panel.curves.push_back(
        {std::move(normal), "normal curve of noise and sampling", kVermillion, Stroke::Line, 7, 1});
  }
  panel.marks = {interval.low / unit.scale, interval.high / unit.scale};
  panel.mark_name = "percentiles";
  double low = panel.curves[0].points[0][0], high = low;
  for (const FigureCurve& curve : panel.curves) {
    for (const auto& point : curve.points) {
      low = std::min(low, point[0]);
      high = std::max(high, point[0]);
    }
  }
  panel.x_range = {low, high};
  return panel;
}

/// The ellipse within which this part of a normal distribution lies that has the values' means and
/// covariance: with two numbers the squared distance is beyond r^2 with probability exp(-r^2/2).
Points ellipse_about(const std::vector<double>& x, double x_scale, const std::vector<double>& y,
                     double y_scale, double part) {
  constexpr int kCorners = 120;
  const auto n = static_cast<double>(x.size());
  const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean) / (n - 1.0);
    xy += (x[i] - x_mean) * (y[i] - y_mean) / (n - 1.0);
    yy += (y[i] - y_mean) * (y[i] - y_mean) / (n - 1.0);
  }
  if (!(xx > 0.0 && yy > 0.0)) return {};
  const double r = std::sqrt(-2.0 * std::log(1.0 - part));
  // A circle through the factor of Cholesky.
  const double along = xy / std::sqrt(xx);
  const double across = std::sqrt(std::max(0.0, yy - along * along));
  Points points;
  for (int k = 0; k <= kCorners; ++k) {
    const double t = 2.0 * std::numbers::pi * k / kCorners;
    points.push_back({(x_mean + r * std::sqrt(xx) * std::cos(t)) / x_scale,
                      (y_mean + r * (along * std::cos(t) + across * std::sin(t))) / y_scale});
  }
  return points;
}

FigurePanel pair_panel(const ShownParameter& a, const std::vector<double>& a_values,
                       const ShownParameter& b, const std::vector<double>& b_values) {
  const DisplayUnit a_unit = report::display_unit(a), b_unit = report::display_unit(b);
  FigurePanel panel;
  // The label of an upright axis would lie on the panel beside it: its numbers are long.
  panel.title = fmt::format("{} [{}] over {}", short_name(b.path), b_unit.name, short_name(a.path));
  panel.x_label = fmt::format("{} [{}]", short_name(a.path), a_unit.name);
  FigureCurve cloud{{}, "resamples", kBlue, Stroke::Points, 7};
  for (std::size_t i = 0; i < a_values.size(); ++i) {
    cloud.points.push_back({a_values[i] / a_unit.scale, b_values[i] / b_unit.scale});
  }
  panel.curves.push_back(std::move(cloud));
  for (const double part : {0.5, 0.95}) {
    Points ellipse = ellipse_about(a_values, a_unit.scale, b_values, b_unit.scale, part);
    if (ellipse.empty()) continue;
    panel.curves.push_back(
        {std::move(ellipse), "50 and 95 % of their normal distribution", kGrey, Stroke::Line});
  }
  const auto range_along = [&](std::size_t axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const FigureCurve& curve : panel.curves) {
      for (const auto& point : curve.points) {
        low = std::min(low, point[axis]);
        high = std::max(high, point[axis]);
      }
    }
    const double room = high > low ? 0.06 * (high - low) : 0.06 * std::fabs(high);
    return std::array{low - room, high + room};
  };
  panel.x_range = range_along(0);
  panel.y_range = range_along(1);
  panel.curves.push_back({{{a.value / a_unit.scale, b.value / b_unit.scale}},
                          "fitted",
                          kVermillion,
                          Stroke::Points,
                          7});
  return panel;
}

}  // namespace

Figure profile_figure(const ShownIntervals& shown) {
  const FitIntervals& all = *shown.intervals;
  Figure figure;
  figure.title = shown.name + ": profile likelihood";
  for (std::size_t i = 0; i < all.profiles.size(); ++i) {
    const LikelihoodProfile& profile = all.profiles[i];
    if (profile.value.size() < 2 || figure.panels.size() == kMaxPanels) continue;
    figure.panels.push_back(profile_panel(shown.parameters.at(i), profile));
  }
  if (figure.panels.empty()) {
    throw InputError({}, "--what", "profile",
                     shown.name + " has no profile: calibrate with --profile");
  }
  return figure;
}

Figure bootstrap_figure(const ShownIntervals& shown) {
  const FitIntervals& all = *shown.intervals;
  const bool of_residuals = all.residuals.resamples > 0;
  const BootstrapResult& bootstrap = of_residuals ? all.residuals : all.specimens;
  const std::size_t n = shown.parameters.size();
  if (n == 0 || bootstrap.values.size() < 2 * n || bootstrap.intervals.size() != n) {
    throw InputError({}, "--what", "bootstrap",
                     shown.name + " has no bootstrap: calibrate with --bootstrap 400");
  }
  std::vector<std::vector<double>> columns;
  std::vector<std::size_t> drawn;  // what the curve does not determine has no interval
  for (std::size_t i = 0; i < n; ++i) {
    columns.push_back(column_of(bootstrap, i, n));
    if (std::isfinite(bootstrap.intervals[i].low)) drawn.push_back(i);
  }
  if (drawn.empty()) {
    throw InputError({}, "--what", "bootstrap", shown.name + " identifies no parameter");
  }
  Figure figure;
  figure.title = fmt::format("{}: {} resamples of the {}", shown.name, columns[0].size(),
                             of_residuals ? "residuals" : "specimens");
  for (const std::size_t i : drawn) {
    if (figure.panels.size() == kMaxPanels) break;
    figure.panels.push_back(
        histogram_panel(shown.parameters[i], bootstrap.intervals[i], columns[i]));
  }
  for (std::size_t a = 0; a < drawn.size(); ++a) {
    for (std::size_t b = a + 1; b < drawn.size() && figure.panels.size() < kMaxPanels; ++b) {
      const std::size_t i = drawn[a], k = drawn[b];
      figure.panels.push_back(
          pair_panel(shown.parameters[i], columns[i], shown.parameters[k], columns[k]));
    }
  }
  return figure;
}

}  // namespace plastica::calibrate::report
