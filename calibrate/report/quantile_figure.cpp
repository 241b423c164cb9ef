#include "calibrate/report/quantile_figure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "calibrate/report/plot_parts.hpp"
#include "plastica/base/check.hpp"
#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::kBlue;
using plastica::report::kDark;
using plastica::report::Stroke;

constexpr std::string_view kBand = "#CFE3F0";

/// Measured minus fitted, where both are numbers.
std::vector<double> residuals_of(const std::vector<double>& measured,
                                 const std::vector<double>& fitted) {
  std::vector<double> residuals;
  for (std::size_t i = 0; i < std::min(measured.size(), fitted.size()); ++i) {
    const double residual = measured[i] - fitted[i];
    if (std::isfinite(residual)) residuals.push_back(residual);
  }
  return residuals;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

void require_noise(const std::vector<double>& residuals, double noise, const std::string& name) {
  if (residuals.empty()) {
    throw InputError({}, "--what", "quantiles", name + " was not fitted");
  }
  if (!(noise > 0.0)) {
    throw InputError({}, "--what", "quantiles", name + " is fitted without a misfit");
  }
}

}  // namespace

FigurePanel quantile_panel(std::vector<double> residuals, double noise) {
  std::ranges::sort(residuals);
  const auto n = static_cast<double>(residuals.size());
  FigurePanel panel;
  panel.x_label = "quantile of the normal distribution";
  panel.y_label = "residual over noise";
  plastica::report::FigureCurve band{
      {}, "95 % of independent normal residuals", kBand, Stroke::Area};
  plastica::report::FigureCurve points{{}, "residual", kDark, Stroke::Points, 7};
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const double p = (static_cast<double>(i + 1) - 0.375) / (n + 0.25);
    const double z = theory::normal_quantile(p);
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    const double half = theory::normal_quantile(0.975) * std::sqrt(p * (1.0 - p) / n) / density;
    band.points.push_back({z, z - half, z + half});
    points.points.push_back({z, residuals[i] / noise});
  }
  const double end = points.points.back()[0];
  panel.curves.push_back(std::move(band));
  panel.curves.push_back({{{-end, -end}, {end, end}}, "normal", kBlue, Stroke::Line});
  panel.curves.push_back(std::move(points));
  return panel;
}

Figure quantiles_figure(const FitRecord& record) {
  std::vector<double> residuals;
  if (is_fitted(record)) {
    residuals = residuals_of(record.target.corrected.stress, record.result.fitted.stress);
  }
  // Not the misfit: that is weighed along the path where the objective is.
  const double noise = record.result.noise.value_or(rms(residuals));
  require_noise(residuals, noise, record.target.name);
  FigurePanel panel = quantile_panel(std::move(residuals), noise);
  panel.title = record.result.noise ? "noise as stated" : "noise: the rms residual";
  return {record.target.name, {std::move(panel)}};
}

Figure quantiles_figure(const SceneFitRecord& record) {
  const std::size_t fitted =
      record.result.status == FitStatus::Fitted ? record.result.targets.size() : 0;
  if (fitted != record.targets.size()) {
    throw InputError({}, "--what", "quantiles", record.name + " was not fitted");
  }
  Figure figure;
  figure.title = record.name;
  for (std::size_t t = 0; t < std::min(fitted, kMaxPanels); ++t) {
    const SceneTarget& target = record.targets[t];
    const TargetFit& of_target = record.result.targets[t];
    std::vector<double> residuals = residuals_of(target.ordinate, of_target.fitted);
    const double noise = std::isfinite(of_target.noise) ? of_target.noise : rms(residuals);
    require_noise(residuals, noise, target.name);
    FigurePanel panel = quantile_panel(std::move(residuals), noise);
    if (record.targets.size() > 1) panel.title = target.name;
    figure.panels.push_back(std::move(panel));
  }
  if (record.targets.size() > kMaxPanels) {
    figure.title += fmt::format(", the first {} of {} targets", kMaxPanels, record.targets.size());
  }
  return figure;
}

}  // namespace plastica::calibrate::report
