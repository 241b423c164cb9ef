#include "sweeps/report/web/scan_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_figure.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "sweeps/stability/stability_map.hpp"

namespace plastica::sweeps::stability {
namespace {

using report::FigureCurve;
using report::Json;
using report::Stroke;

constexpr report::LogarithmicAxes kBoth{true, true};
constexpr int kOwnSymbol = 12;  ///< open: the symbol of its verdict is seen in it

/// Points of one class, with what a pointer is told of each.
struct ClassPoints {
  FigureCurve curve;
  std::vector<std::string> labels;
};

std::array<ClassPoints, 4> classes_of_points() {
  std::array<ClassPoints, 4> all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto validity = static_cast<Validity>(k);
    all[k].curve = {{},
                    k == 3 ? "undetected error" : std::string(kValidity[k]),
                    class_colour(validity),
                    Stroke::Points,
                    class_symbol(validity)};
  }
  return all;
}

void add_classes(const std::array<ClassPoints, 4>& classes, Json& curves) {
  for (const ClassPoints& one : classes) {
    if (!one.curve.points.empty()) {
      curves.push_back(report::web_curve(one.curve, kBoth, 0, one.labels));
    }
  }
}

/// "beam.segments = 4, inaccurate: tip: …".
std::string told_of(const StabilityRow& row) {
  std::string text;
  for (const ScannedValue& at : row.at) {
    text += fmt::format("{}{} = {}{}", text.empty() ? "" : ", ", at.axis, report::brief(at.value),
                        at.unit == "1" ? "" : " " + at.unit);
  }
  if (text.empty()) text = "as the scene is";
  text += fmt::format(", {}", kValidity[static_cast<std::size_t>(row.verdict.validity)]);
  return row.verdict.reason.empty() ? text : text + ": " + row.verdict.reason;
}

bool is_along(const StabilityRow& row, const ScannedField& field) {
  return row.at.empty() || (row.at.size() == 1 && row.at[0].axis == field.field->path);
}

double factor_of(const StabilityRow& row, const ScannedField& field) {
  return row.at.empty() ? 1.0 : row.at[0].value / field.value;
}

Json deviation_panel(const SceneScan& scan, const ScannedField& field,
                     const SceneScanOptions& options) {
  std::array<ClassPoints, 4> classes = classes_of_points();
  report::FigurePanel panel{std::string(field.field->path), "factor on it",
                            "deviation from a finer run [%]"};
  std::array<double, 2> reach{1.0, 1.0};
  const double within = 100.0 * options.within;
  std::array<double, 2> seen{within, within};
  std::size_t exact = 0;
  std::vector<std::string> without;  // words of points that have no deviation
  for (const StabilityRow& row : scan.rows) {
    if (!is_along(row, field)) continue;
    const double factor = factor_of(row, field);
    reach = {std::min(reach[0], factor), std::max(reach[1], factor)};
    const auto validity = static_cast<std::size_t>(row.verdict.validity);
    if (!row.deviation || !std::isfinite(*row.deviation)) {
      panel.marks.push_back(factor);
      const std::string word(kValidity[validity]);
      if (std::ranges::find(without, word) == without.end()) without.push_back(word);
    } else if (*row.deviation <= 0.0) {
      ++exact;  // which has no place on a logarithmic axis
    } else {
      const double percent = 100.0 * *row.deviation;
      seen = {std::min(seen[0], percent), std::max(seen[1], percent)};
      classes[validity].curve.points.push_back({factor, percent});
      classes[validity].labels.push_back(told_of(row));
    }
  }
  if (exact > 0) {
    panel.title +=
        fmt::format(" (without {} whose deviation is 0)", report::counted(exact, "point"));
  }
  if (!without.empty()) {
    panel.mark_name = fmt::format("{}: no deviation", fmt::join(without, ", "));
  }
  // With room for the symbols at the ends.
  panel.x_range = {reach[0] / 1.4, 1.4 * reach[1]};
  panel.y_range = {seen[0] / 2.0, 2.0 * seen[1]};
  FigureCurve limit{{{panel.x_range[0], within}, {panel.x_range[1], within}},
                    fmt::format("valid up to {:g} %", within),
                    report::kDark,
                    Stroke::Line,
                    7,
                    1};
  Json curves = Json::array();
  add_classes(classes, curves);
  curves.push_back(report::web_curve(limit, kBoth, 0));
  return report::web_panel(panel, kBoth, std::move(curves));
}

std::string label_of(const ScannedField& field) {
  const std::string_view unit = si_unit(field.field->dimension);
  std::string text(field.field->path);
  if (field.value < 0.0) text = "-" + text;
  return unit == "1" ? text : fmt::format("{} [{}]", text, unit);
}

}  // namespace

Json deviation_figure(const SceneScan& scan, const SceneScanOptions& options) {
  Json panels = Json::array();
  for (const ScannedField& field : scan.fields) {
    if (field.matters()) panels.push_back(deviation_panel(scan, field, options));
  }
  if (panels.empty()) return nullptr;
  return report::web_panels("Deviation from a finer run", std::move(panels));
}

Json pair_figure(std::span<const StabilityRow> rows, const ScannedField& first,
                 const ScannedField& second) {
  std::array<ClassPoints, 4> classes = classes_of_points();
  for (const StabilityRow& row : rows) {
    ClassPoints& one = classes[static_cast<std::size_t>(row.verdict.validity)];
    // What is negative is so for all points: a factor changes no sign.
    one.curve.points.push_back({std::fabs(row.at[0].value), std::fabs(row.at[1].value)});
    one.labels.push_back(told_of(row));
  }
  const FigureCurve own{{{std::fabs(first.value), std::fabs(second.value)}},
                        "the scene's own",
                        report::kDark,
                        Stroke::Points,
                        kOwnSymbol};
  Json curves = Json::array();
  curves.push_back(report::web_curve(own, kBoth, 0));
  add_classes(classes, curves);
  const report::FigurePanel panel{"each point a run", label_of(first), label_of(second)};
  Json panels = Json::array();
  panels.push_back(report::web_panel(panel, kBoth, std::move(curves)));
  return report::web_panels("Map", std::move(panels));
}

}  // namespace plastica::sweeps::stability
