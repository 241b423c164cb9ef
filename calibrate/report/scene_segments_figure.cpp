#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calibrate/inference/material_interval.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_figures.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::kBlue;
using plastica::report::kDark;
using plastica::report::kGrey;
using plastica::report::kVermillion;
using plastica::report::Stroke;

/// f_0 + C h^p from the continuous beam to the longest segments, h over the fit's.
FigureCurve power_of(const SegmentsError& error, double longest, double scale) {
  constexpr int kPoints = 60;
  FigureCurve curve{{}, "power of the order", kVermillion, Stroke::Line};
  for (int i = 0; i <= kPoints; ++i) {
    const double h = longest * i / kPoints;
    const double value =
        error.extrapolated + (error.at_own - error.extrapolated) * std::pow(h, error.order);
    curve.points.push_back({h, value / scale});
  }
  return curve;
}

/// "order 2.00", "assumed order 2", "oscillates".
std::string trend_text(const SegmentsError& error) {
  if (error.trend == SegmentsTrend::Monotone) return fmt::format("order {:.2f}", error.order);
  if (error.trend == SegmentsTrend::Assumed) return fmt::format("assumed order {:g}", error.order);
  return std::string(name_of(error.trend));
}

/// Of all that curves show, the ends of bars among it, with room.
std::array<double, 2> range_of(const std::vector<FigureCurve>& curves) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const FigureCurve& curve : curves) {
    for (const auto& point : curve.points) {
      for (std::size_t k = 1; k < point.size(); ++k) {
        if (!std::isfinite(point[k])) continue;
        low = std::min(low, point[k]);
        high = std::max(high, point[k]);
      }
    }
  }
  const double room = 0.06 * (high - low);
  return {low - room, high + room};
}

FigurePanel panel_of(const FittedParameter& parameter, const SegmentsError& error) {
  const DisplayUnit unit = display_unit(parameter);
  FigurePanel panel;
  panel.title = short_name(parameter.path);
  if (!unit.name.empty()) panel.title += fmt::format(" [{}]", unit.name);
  panel.title += ", " + trend_text(error);
  panel.x_label = "segment's length over the fit's";
  FigureCurve fits{{}, "fitted", kDark, Stroke::Points, 7};
  for (const auto& [h, value] : {std::pair{2.0, error.at_half}, std::pair{1.0, error.at_own},
                                 std::pair{0.5, error.at_twice}}) {
    if (std::isfinite(value)) fits.points.push_back({h, value / unit.scale});
  }
  const double longest = fits.points.empty() ? 1.0 : fits.points.front()[0];
  if (std::isfinite(error.order)) panel.curves.push_back(power_of(error, longest, unit.scale));
  if (std::isfinite(parameter.interval_low) && std::isfinite(parameter.interval_high)) {
    const double middle = 0.5 * (parameter.interval_low + parameter.interval_high);
    const bool of_material = is_of_material(parameter, error);
    panel.curves.push_back(
        {{{of_material ? -0.03 * longest : 1.0, middle / unit.scale,
           parameter.interval_low / unit.scale, parameter.interval_high / unit.scale}},
         of_material ? "interval of the material" : "interval of noise and sampling",
         kGrey,
         Stroke::Bars});
  }
  panel.curves.push_back({{{0.0, error.extrapolated / unit.scale,
                            (error.extrapolated - error.extrapolated_error) / unit.scale,
                            (error.extrapolated + error.extrapolated_error) / unit.scale}},
                          "continuous beam, extrapolated",
                          kBlue,
                          Stroke::Bars});
  panel.curves.push_back(std::move(fits));
  panel.x_range = {-0.06 * longest, 1.06 * longest};
  panel.y_range = range_of(panel.curves);
  return panel;
}

}  // namespace

Figure segments_figure(const SceneFitRecord& record) {
  const SceneFitResult& result = record.result;
  if (!result.segments) {
    throw InputError({}, "--what", "segments",
                     record.name + " was not repeated with other segments");
  }
  Figure figure;
  figure.title = fmt::format("{}: fits with half, once and twice {} segments", record.name,
                             result.segments->segments);
  for (std::size_t i = 0; i < result.segments->parameters.size(); ++i) {
    const SegmentsError& error = result.segments->parameters[i];
    if (error.trend == SegmentsTrend::Unknown || figure.panels.size() == kMaxPanels) continue;
    figure.panels.push_back(panel_of(result.parameters[i], error));
  }
  if (figure.panels.empty()) {
    throw InputError({}, "--what", "segments",
                     record.name + " has no parameter of which their error is known");
  }
  return figure;
}

}  // namespace plastica::calibrate::report
