#include "calibrate/report/laws_figure.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/scene_words.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::curve_of_record;
using plastica::report::FigureCurve;
using plastica::report::FigurePanel;
using plastica::report::kDark;
using plastica::report::Stroke;

/// What a law makes of a target.
struct LawCurve {
  std::string name;       ///< "voce, 0.31 %": its misfit
  std::vector<double> y;  ///< at the samples; empty if it was not fitted
};

/// A measured curve in the units that are shown.
struct Shown {
  std::string title, x_label, y_label;
  std::vector<double> x, y;
};

template <typename Record, typename NameOf>
std::vector<const Record*> laws_of(std::span<const Record> records, const std::string& name,
                                   const NameOf& name_of) {
  if (!compares_laws(records)) {
    throw InputError({}, "--what", "laws", "there are none to compare: calibrate with --laws");
  }
  const auto targets = by_target(records);
  for (const auto& target : targets) {
    if (name.empty() || name_of(*target.front()) == name) return target;
  }
  std::string names;
  for (std::size_t i = 0; i < std::min<std::size_t>(targets.size(), 8); ++i) {
    names += (i == 0 ? "" : ", ") + name_of(*targets[i].front());
  }
  throw InputError({}, "--case", name, "is not in this file; it has " + names);
}

FigureCurve curve(const std::vector<double>& x, const std::vector<double>& y, FigureCurve how) {
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) how.points.push_back({x[i], y[i]});
  }
  return how;
}

void add_panels(const Shown& shown, const std::vector<LawCurve>& laws, Figure& figure) {
  FigurePanel over, below;
  over.title = shown.title;
  over.x_label = below.x_label = shown.x_label;
  over.y_label = shown.y_label;
  below.title = "measured - fitted";
  below.y_label = shown.y_label;
  const bool few = shown.x.size() <= 400;
  FigureCurve measured{{}, "measured", kDark, few ? Stroke::Points : Stroke::Line, 6};
  over.curves.push_back(curve(shown.x, shown.y, std::move(measured)));
  for (std::size_t k = 0; k < laws.size(); ++k) {
    if (laws[k].y.empty()) continue;
    FigureCurve how = curve_of_record(k, laws.size(), laws[k].name);
    how.stroke = Stroke::Line;
    how.dashes = static_cast<int>(k);  // laws that come to the same lie over each other
    std::vector<double> off;
    const std::size_t samples = std::min(shown.y.size(), laws[k].y.size());
    off.reserve(samples);
    for (std::size_t i = 0; i < samples; ++i) {
      off.push_back(shown.y[i] - laws[k].y[i]);
    }
    below.curves.push_back(curve(shown.x, off, how));
    over.curves.push_back(curve(shown.x, laws[k].y, std::move(how)));
  }
  if (below.curves.empty()) {
    throw InputError({}, "--what", "laws", shown.title + ": no law was fitted");
  }
  figure.panels.push_back(std::move(over));
  figure.panels.push_back(std::move(below));
}

std::string law_text(Law law, double misfit_fraction) {
  return fmt::format("{}, {:.2g} %", name_of(law), 100.0 * misfit_fraction);
}

std::vector<double> in_units(const std::vector<double>& values, double scale) {
  std::vector<double> shown;
  shown.reserve(values.size());
  for (const double value : values) shown.push_back(value / scale);
  return shown;
}

}  // namespace

void refuse_law(const PlotRequest& request) {
  if (request.law.empty()) return;
  throw InputError({}, "--law", request.law, "does not go with the picture 'laws', which has all");
}

Figure laws_figure(std::span<const FitRecord> records, const std::string& name) {
  const auto laws =
      laws_of(records, name, [](const FitRecord& record) { return record.target.name; });
  const Target& target = laws.front()->target;
  const Curve& measured = measured_of(*laws.front());
  constexpr double kPercent = 0.01, kMega = 1e6;
  const Shown shown{target.name, strain_label(target), stress_label(target),
                    in_units(measured.strain, kPercent), in_units(measured.stress, kMega)};
  std::vector<LawCurve> curves;
  for (const FitRecord* record : laws) {
    const FitResult& result = record->result;
    if (!is_fitted(*record)) continue;
    // Beyond the samples stands the model's break.
    std::vector<double> stress = in_units(result.fitted.stress, kMega);
    stress.resize(std::min(stress.size(), measured.size()));
    curves.push_back({law_text(result.law, result.misfit_fraction), std::move(stress)});
  }
  Figure figure;
  add_panels(shown, curves, figure);
  return figure;
}

Figure laws_figure(std::span<const SceneFitRecord> records, const std::string& name) {
  const auto laws =
      laws_of(records, name, [](const SceneFitRecord& record) { return record.name; });
  const SceneFitRecord& first = *laws.front();
  Figure figure;
  const std::size_t shown_targets = std::min(first.targets.size(), kMaxPanels / 2);
  figure.title = first.targets.size() == 1 ? "" : first.name;
  if (shown_targets < first.targets.size()) {
    figure.title +=
        fmt::format(", the first {} of {} targets", shown_targets, first.targets.size());
  }
  const auto unit_of = [](Dimension dimension, const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::fabs(value));
    return plastica::report::shown_unit(dimension, most);
  };
  const auto label = [](const std::string& what, const DisplayUnit& unit) {
    return unit.name.empty() ? what : fmt::format("{} [{}]", what, unit.name);
  };
  for (std::size_t t = 0; t < shown_targets; ++t) {
    const SceneTarget& target = first.targets[t];
    const DisplayUnit x_unit = unit_of(target.abscissa_is, target.abscissa);
    const DisplayUnit y_unit = unit_of(target.ordinate_is, target.ordinate);
    const Shown shown{cut(target.name, 34), label(abscissa_text(target), x_unit),
                      label(printable(target.ordinate_probe), y_unit),
                      in_units(target.abscissa, x_unit.scale),
                      in_units(target.ordinate, y_unit.scale)};
    std::vector<LawCurve> curves;
    for (const SceneFitRecord* record : laws) {
      if (record->result.targets.size() != record->targets.size()) continue;
      const TargetFit& of_target = record->result.targets[t];
      curves.push_back({law_text(record->result.law, of_target.misfit_fraction),
                        in_units(of_target.fitted, y_unit.scale)});
    }
    add_panels(shown, curves, figure);
  }
  return figure;
}

}  // namespace plastica::calibrate::report
