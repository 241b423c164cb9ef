#include "calibrate/report/scene_fit_bands.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "plastica/theory/statistics.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::FigureCurve;
using plastica::report::Stroke;
using Points = std::vector<std::vector<double>>;

constexpr std::string_view kNarrowBand = "#9CC4DE";
constexpr std::string_view kWideBand = "#DDEBF4";

}  // namespace

std::vector<FigureCurve> bands_of(const SceneTarget& target, const TargetFit& of_target,
                                  const DisplayUnit& x_unit, const DisplayUnit& y_unit) {
  std::vector<FigureCurve> bands;
  if (of_target.fitted.empty() || of_target.fitted_error.size() != of_target.fitted.size() ||
      of_target.fitted.size() != target.abscissa.size() || !(of_target.degrees_of_freedom > 0.0)) {
    return bands;
  }
  const double factor = theory::student_t_quantile(0.975, of_target.degrees_of_freedom);
  const bool grows = std::ranges::is_sorted(target.abscissa);
  for (const bool of_sample : {true, false}) {
    const char* name = of_sample ? "95 % of new samples" : "95 % of the curve";
    const std::string_view color = of_sample ? kWideBand : kNarrowBand;
    Points area, low, high;
    for (std::size_t i = 0; i < of_target.fitted.size(); ++i) {
      const double noise = of_sample ? of_target.noise : 0.0;
      const double reach = factor * std::hypot(of_target.fitted_error[i], noise);
      const double x = target.abscissa[i] / x_unit.scale;
      const double least = (of_target.fitted[i] - reach) / y_unit.scale;
      const double most = (of_target.fitted[i] + reach) / y_unit.scale;
      if (!std::isfinite(least)) continue;
      area.push_back({x, least, most});
      low.push_back({x, least});
      high.push_back({x, most});
    }
    if (grows) {
      bands.push_back({std::move(area), name, color, Stroke::Area});
    } else {
      bands.push_back({std::move(low), name, color, Stroke::Line});
      bands.push_back({std::move(high), name, color, Stroke::Line});
    }
  }
  return bands;
}

}  // namespace plastica::calibrate::report
