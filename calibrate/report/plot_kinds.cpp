#include "calibrate/report/plot_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "calibrate/report/format.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/base/check.hpp"

namespace plastica::calibrate::report {
namespace {

constexpr std::size_t kMostPanels = 12;
constexpr std::size_t kMostCurves = 60;  // of a panel; more are a blot

const FittedParameter* find_parameter(const FitResult& result, std::string_view name) {
  for (const FittedParameter& parameter : result.parameters) {
    if (parameter.name == name) return &parameter;
  }
  return nullptr;
}

bool is_fitted(const FitRecord& record) { return record.result.status == FitStatus::Fitted; }

const Curve& measured_of(const FitRecord& record) {
  return record.target.corrected.size() > 0 ? record.target.corrected : record.target.raw;
}

std::string measured_parameter(const FitResult& result, std::string_view name,
                               std::string_view symbol, std::string_view remark) {
  const FittedParameter* parameter = find_parameter(result, name);
  if (parameter == nullptr) return {};
  const DisplayUnit unit = display_unit(*parameter);
  const double value = parameter->value / unit.scale;
  const std::string number = parameter->standard_error
                                 ? with_error(value, *parameter->standard_error / unit.scale)
                                 : significant(value, 4);
  return fmt::format("{} {} {}{}", symbol, number, unit.name, remark);
}

std::string subtitle_of(const FitRecord& record) {
  if (!is_fitted(record)) {
    return cut(fmt::format("{}: {}", word_of(record.result.status), reason_of(record)), 100);
  }
  const FitResult& result = record.result;
  std::string line;
  for (const std::string& part :
       {measured_parameter(result, "youngs_modulus", "E", ""),
        measured_parameter(result, "yield_stress", "σ_y", ""),
        measured_parameter(result, "shear_yield_stress", "τ_y", ""),
        measured_parameter(result, "break_strain", "ε_break", " permanent"),
        measured_parameter(result, "break_shear_strain", "γ_break", " permanent"),
        fmt::format("misfit {} %", significant(100.0 * result.misfit_share, 2))}) {
    if (!part.empty()) line += (line.empty() ? "" : "    ") + part;
  }
  return line;
}

std::string strain_label(const Target& target) {
  return fmt::format("{}{} strain [%]", word_of(target.measure),
                     target.test == Test::Torsion ? " shear" : "");
}

std::string stress_label(const Target& target) {
  return fmt::format("{}{} stress [MPa]", word_of(target.measure),
                     target.test == Test::Torsion ? " shear" : "");
}

/// Where the fitted curve leaves the elastic line: first point at the fitted yield stress.
std::optional<std::vector<double>> yield_point(const FitResult& result) {
  const FittedParameter* yield = find_parameter(result, "yield_stress");
  if (yield == nullptr) yield = find_parameter(result, "shear_yield_stress");
  const FittedParameter* modulus = find_parameter(result, "youngs_modulus");
  if (yield == nullptr || !yield->identified) return std::nullopt;
  if (modulus != nullptr && yield->name == "yield_stress" && modulus->value > 0.0) {
    return std::vector<double>{100.0 * yield->value / modulus->value, 1e-6 * yield->value};
  }
  for (std::size_t i = 0; i < result.fitted.size(); ++i) {
    if (result.fitted.stress[i] >= yield->value * (1.0 - 1e-9)) {
      return std::vector<double>{100.0 * result.fitted.strain[i], 1e-6 * yield->value};
    }
  }
  return std::nullopt;
}

/// The fitted curve up to its break, and the fall to zero there.
Curve fitted_with_break(const FitResult& result) {
  Curve curve = result.fitted;
  if (!result.break_strain_total || curve.size() == 0) return curve;
  const double strain = *result.break_strain_total;
  const bool falls = std::any_of(curve.stress.begin() + 1, curve.stress.end(),
                                 [](double stress) { return stress == 0.0; });
  if (falls) return curve;
  const double stress = curve.stress.back();
  if (strain > curve.strain.back()) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress);
  }
  curve.strain.push_back(curve.strain.back());
  curve.stress.push_back(0.0);
  return curve;
}

/// Every specimen's break as (strain in %, stress in MPa).
void add_break(const FitRecord& record, std::vector<std::vector<double>>& rows) {
  const std::optional<BreakObservation>& seen = record.target.characteristics.observed_break;
  if (seen) rows.push_back({100.0 * seen->strain(), 1e-6 * seen->last_whole_stress});
}

void join(std::string& plot, const std::string& part) {
  plot += (plot.empty() ? "plot " : ", \\\n     ") + part;
}

}  // namespace

PlotScript curve_plot(const FitRecord& record) {
  const Target& target = record.target;
  const Curve& measured = measured_of(record);
  if (measured.size() == 0) {
    throw InputError({}, "--case", target.name, "has no curve to draw: " + reason_of(record));
  }
  PlotScript script;
  script.command("set title " + quoted(target.name) + ".\"\\n\"." + quoted(subtitle_of(record)) +
                 " textcolor rgb '#333333'");
  script.command("set xlabel " + quoted(strain_label(target)));
  script.command("set ylabel " + quoted(stress_label(target)));
  const bool cyclic = target.loading == Loading::Cyclic;
  if (cyclic) {
    script.command("set xzeroaxis linecolor rgb '#B8B8B8'");
  } else {
    script.command(
        "set xrange [0:*]\nset yrange [0:*]\nset offsets graph 0, graph 0.03, graph "
        "0.08, graph 0");
  }
  std::string plot;
  join(plot,
       fmt::format("{} using 1:2 with {} title 'measured'", script.add_curve(measured),
                   measured.size() < 80 && !cyclic
                       ? fmt::format("points pointtype 7 pointsize 0.5 linecolor rgb '{}'", kGrey)
                       : fmt::format("lines linewidth 1.6 linecolor rgb '{}'", kGrey)));
  if (is_fitted(record) && record.result.fitted.size() > 0) {
    join(plot,
         fmt::format("{} using 1:2 with lines linewidth 2.2 linecolor rgb '{}' title 'fitted'",
                     script.add_curve(fitted_with_break(record.result)), kVermillion));
    if (const auto yield = yield_point(record.result); yield && !cyclic) {
      join(plot, fmt::format("{} using 1:2 with points pointtype 7 pointsize 0.9 linecolor rgb "
                             "'{}' title 'yield, fitted'",
                             script.add_points({*yield}), kVermillion));
    }
  }
  std::vector<std::vector<double>> breaks;
  add_break(record, breaks);
  if (!breaks.empty()) {
    join(plot, fmt::format("{} using 1:2 with points pointtype 2 pointsize 1.2 linewidth 2 "
                           "linecolor rgb '{}' title 'break, measured'",
                           script.add_points(breaks), kBlue));
  }
  script.command(plot);
  return script;
}

PlotScript overview_plot(std::span<const FitRecord> records) {
  std::vector<std::vector<std::size_t>> groups = group_indices(records);
  PlotScript script;
  const std::size_t all = groups.size();
  groups.resize(std::min(all, kMostPanels));
  const std::size_t columns = groups.size() == 1 ? 1 : (groups.size() <= 4 ? 2 : 3);
  const std::size_t rows = (groups.size() + columns - 1) / columns;
  script.relative_height = std::max(1.0, 0.62 * static_cast<double>(rows));

  double most_strain = 0.0;
  double most_stress = 0.0;
  bool cyclic = false;
  for (const FitRecord& record : records) {
    cyclic = cyclic || record.target.loading == Loading::Cyclic;
    const Curve& curve = measured_of(record);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (std::isfinite(curve.strain[i])) most_strain = std::max(most_strain, curve.strain[i]);
      if (std::isfinite(curve.stress[i])) most_stress = std::max(most_stress, curve.stress[i]);
    }
  }
  const Target& first = records.front().target;
  script.command("set xlabel " + quoted(strain_label(first)));
  script.command("set ylabel " + quoted(stress_label(first)));
  if (!cyclic && most_strain > 0.0 && most_stress > 0.0) {
    // One scale for all panels, so that groups can be compared.
    script.command(fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]", 104.0 * most_strain,
                               1.08e-6 * most_stress));
  }
  if (groups.size() > 1) {
    const std::string left_out =
        all > groups.size() ? fmt::format(" title 'the first {} of {} groups'", groups.size(), all)
                            : std::string();
    script.command(fmt::format("set multiplot layout {},{}{}", rows, columns, left_out));
  }
  for (const std::vector<std::size_t>& members : groups) {
    std::vector<const Curve*> measured;
    std::vector<Curve> fits;
    std::vector<std::vector<double>> breaks;
    const std::size_t step = (members.size() + kMostCurves - 1) / kMostCurves;
    std::vector<const Curve*> whole;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const FitRecord& record = records[members[k]];
      if (record.target.status == TargetStatus::Rejected || measured_of(record).size() < 2)
        continue;
      whole.push_back(&measured_of(record));
      if (k % step != 0) continue;
      measured.push_back(whole.back());
      add_break(record, breaks);
      if (is_fitted(record) && record.result.fitted.size() > 0) {
        fits.push_back(fitted_with_break(record.result));
      }
    }
    std::string title = fmt::format("{} ({}", group_label(records[members.front()].target.group),
                                    counted(members.size(), "specimen"));
    if (measured.size() < members.size()) title += fmt::format(", {} drawn", measured.size());
    script.command("set title " + quoted(title + ")") + " textcolor rgb '#333333'");
    std::string plot;
    if (!measured.empty()) {
      join(plot, fmt::format("{} using 1:2 with lines linewidth 0.9 linecolor rgb '{}' title "
                             "'measured'",
                             script.add_curves(measured), kLight));
    }
    if (!fits.empty()) {
      std::vector<const Curve*> pointers;
      for (const Curve& fit : fits) pointers.push_back(&fit);
      join(plot, fmt::format("{} using 1:2 with lines linewidth 0.7 linecolor rgb '{}' title "
                             "'fitted'",
                             script.add_curves(pointers), kVermillion));
    }
    const Curve mean = mean_curve(whole);
    if (mean.size() > 0) {
      join(plot, fmt::format("{} using 1:2 with lines linewidth 2.4 linecolor rgb '{}' title "
                             "'mean, while all are whole'",
                             script.add_curve(mean), kBlue));
    }
    if (!breaks.empty()) {
      join(plot, fmt::format("{} using 1:2 with points pointtype 2 pointsize 0.7 linewidth 1.4 "
                             "linecolor rgb '{}' title 'break'",
                             script.add_points(breaks), kDark));
    }
    script.command(plot.empty() ? "plot NaN notitle" : plot);
  }
  if (groups.size() > 1) script.command("unset multiplot");
  return script;
}

PlotScript parameters_plot(std::span<const FitRecord> records) {
  const std::vector<std::vector<std::size_t>> groups = group_indices(records);
  std::vector<FittedParameter> shown;
  for (const FitRecord& record : records) {
    if (!is_fitted(record)) continue;
    for (const FittedParameter& parameter : record.result.parameters) {
      if (parameter.role == ParameterRole::Free) shown.push_back(parameter);
    }
    break;
  }
  if (shown.empty()) throw InputError({}, "--what", "parameters", "there is no fitted specimen");
  PlotScript script;
  const std::size_t columns = shown.size() == 1 ? 1 : (shown.size() <= 4 ? 2 : 3);
  const std::size_t rows = (shown.size() + columns - 1) / columns;
  script.relative_height = std::max(1.0, 0.62 * static_cast<double>(rows));
  script.command(fmt::format("set multiplot layout {},{}", rows, columns));
  script.command(
      fmt::format("set xrange [0.4:{:.1f}]\nset offsets graph 0, graph 0, graph 0.08, "
                  "graph 0.08",
                  static_cast<double>(groups.size()) + 0.6));
  // Labels that would run into each other are turned.
  std::string tics = groups.size() > 5 ? "set xtics rotate by -35 (" : "set xtics (";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::string label = cut(group_label(records[groups[g].front()].target.group), 24);
    tics += fmt::format("{}{} {}", g == 0 ? "" : ", ", quoted_tic(label), g + 1);
  }
  script.command(tics + ")");
  for (const FittedParameter& parameter : shown) {
    const DisplayUnit unit = display_unit(parameter);
    std::vector<std::vector<double>> points;
    std::vector<std::vector<double>> means;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      std::vector<double> values;
      for (std::size_t k = 0; k < groups[g].size(); ++k) {
        const FitRecord& record = records[groups[g][k]];
        if (!is_fitted(record)) continue;
        const FittedParameter* found = find_parameter(record.result, parameter.name);
        if (found == nullptr || !found->identified) continue;
        values.push_back(found->value / unit.scale);
        // Spread sideways by the golden ratio: even, and the same in each picture.
        const double spread = std::fmod(0.6180339887 * static_cast<double>(k + 1), 1.0) - 0.5;
        points.push_back({static_cast<double>(g + 1) + 0.36 * spread, values.back(),
                          found->standard_error.value_or(0.0) / unit.scale});
      }
      const Statistic statistic = statistic_of(std::move(values));
      if (statistic.n > 1) {
        means.push_back({static_cast<double>(g + 1) + 0.3, statistic.mean,
                         statistic.standard_deviation.value_or(0.0)});
      }
    }
    script.command("set title " + quoted(parameter.name) + " textcolor rgb '#333333'");
    script.command("set ylabel " + quoted(unit.name.empty() ? "value" : unit.name));
    std::string plot;
    if (!points.empty()) {
      join(plot,
           fmt::format("{} using 1:2:3 with yerrorbars pointtype 7 pointsize {} linewidth 0.7 "
                       "linecolor rgb '{}' title 'specimens, standard error'",
                       script.add_points(points), points.size() > 200 ? 0.25 : 0.5, kGrey));
    }
    if (!means.empty()) {
      join(plot, fmt::format("{} using 1:2:3 with yerrorbars pointtype 5 pointsize 0.8 linewidth 2 "
                             "linecolor rgb '{}' title 'mean, standard deviation'",
                             script.add_points(means), kBlue));
    }
    script.command(plot.empty() ? "plot NaN notitle" : plot);
  }
  script.command("unset multiplot");
  return script;
}

}  // namespace plastica::calibrate::report
