#include "calibrate/report/web/specimen_figure.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "calibrate/report/format.hpp"
#include "calibrate/report/plot_data.hpp"
#include "calibrate/report/plot_parts.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::Figure;
using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::Stroke;

constexpr std::string_view kGreen = "#009E73";
constexpr std::string_view kPurple = "#CC79A7";

std::vector<std::vector<double>> rows_of(const Curve& curve) {
  std::vector<std::vector<double>> rows;
  rows.reserve(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    rows.push_back({100.0 * curve.strain[i], 1e-6 * curve.stress[i]});
  }
  return rows;
}

bool is_same(const Curve& a, const Curve& b) {
  return a.strain == b.strain && a.stress == b.stress;
}

/// The elastic line over the window of the modulus.
FigureCurve modulus_line(const Characteristics& c, const char* label) {
  FigureCurve line{{}, std::string("window of ") + label, kGreen};
  const double low = c.modulus_window_low;
  const double high = c.modulus_window_high;
  for (const double stress : {low, high}) {
    line.points.push_back({100.0 * stress / *c.youngs_modulus, 1e-6 * stress});
  }
  return line;
}

FigurePanel curve_panel(const FitRecord& record, bool with_raw) {
  const Target& target = record.target;
  FigurePanel panel{"", strain_label(target), stress_label(target)};
  const auto add = [&](FigureCurve curve) {
    if (!curve.points.empty()) panel.curves.push_back(std::move(curve));
  };
  if (with_raw && !is_same(target.raw, target.corrected)) {
    add({rows_of(target.raw), "as read", kGrey, Stroke::Line, 7, 2});
  }
  add({rows_of(target.corrected), "corrected", kBlue});
  const Characteristics& c = target.characteristics;
  if (c.youngs_modulus && *c.youngs_modulus > 0.0 && c.modulus_window_high > c.modulus_window_low) {
    add(modulus_line(c, target.test == Test::Torsion ? "G" : "E"));
  }
  if (is_fitted(record)) {
    add({rows_of(fitted_with_fall(record.result)), "fitted", kVermillion, Stroke::Line, 7, 1});
    const auto yield = yield_point(record.result);
    // Of torsion the curve is in shear: yield stress over Young's modulus is no point of it.
    if (yield && target.test != Test::Torsion) {
      add({{*yield}, "fitted yield", kVermillion, Stroke::Points, 9});
    }
  }
  if (c.proof_stress && c.youngs_modulus && c.offset) {
    add({{{100.0 * (*c.proof_stress / *c.youngs_modulus + *c.offset), 1e-6 * *c.proof_stress}},
         "proof stress",
         kDark,
         Stroke::Points,
         13});
  }
  std::vector<std::vector<double>> breaks;
  add_break(record, breaks);
  for (auto& point : breaks) point.resize(2);
  add({std::move(breaks), "break", kPurple, Stroke::Points, 5});
  return panel;
}

/// Measured less fitted at the samples that both have.
FigurePanel residual_panel(const FitRecord& record) {
  const Curve& measured = record.target.corrected;
  const Curve& fitted = record.result.fitted;
  FigurePanel panel{"measured less fitted", strain_label(record.target), "residual [MPa]"};
  FigureCurve curve{{}, "residual", kBlue};
  const std::size_t n = std::min(measured.size(), fitted.size());
  for (std::size_t i = 0; i < n && fitted.strain[i] == measured.strain[i]; ++i) {
    curve.points.push_back(
        {100.0 * measured.strain[i], 1e-6 * (measured.stress[i] - fitted.stress[i])});
  }
  if (curve.points.empty()) return panel;
  const double first = 100.0 * *std::ranges::min_element(measured.strain);
  const double last = 100.0 * *std::ranges::max_element(measured.strain);
  panel.curves.push_back(std::move(curve));
  panel.curves.push_back({{{first, 0.0}, {last, 0.0}}, "", kDark, Stroke::Line, 7, 2});
  return panel;
}

}  // namespace

Figure specimen_figure(const FitRecord& record, bool with_raw) {
  Figure figure;
  FigurePanel curve = curve_panel(record, with_raw);
  if (!curve.curves.empty()) figure.panels.push_back(std::move(curve));
  if (is_fitted(record)) {
    FigurePanel residuals = residual_panel(record);
    if (!residuals.curves.empty()) figure.panels.push_back(std::move(residuals));
  }
  return figure;
}

}  // namespace plastica::calibrate::report
