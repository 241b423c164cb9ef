#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "calibrate/inference/mean_interval.hpp"
#include "calibrate/report/fit_flags.hpp"
#include "calibrate/report/outcome_text.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/repairs_text.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/scene_population.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/report/ink.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;
using Align = Table::Align;

/// Parameters that the table over fits has room for; the report of a fit has all.
constexpr std::size_t kMaxColumns = 3;

/// A parameter's column: its unit fits the largest value.
struct ColumnParameter {
  std::string path;
  DisplayUnit unit;
};

std::vector<ColumnParameter> column_parameters(std::span<const SceneFitRecord> records,
                                               const ScenePopulation& population) {
  std::vector<ColumnParameter> shown;
  for (const PopulationParameter& parameter : population.parameters) {
    double most = 0.0;
    for (const SceneFitRecord& record : records) {
      const FittedParameter* found = record.result.find_parameter(parameter.path);
      if (found != nullptr) most = std::fmax(most, std::fabs(found->value));
    }
    shown.push_back({parameter.path, display_unit_of(parameter.path, parameter.dimension, most)});
  }
  return shown;
}

double largest_misfit(const SceneFitResult& result) {
  double most = 0.0;
  for (const TargetFit& of_target : result.targets)
    most = std::fmax(most, of_target.misfit_fraction);
  return most;
}

std::vector<std::string> row_of(const SceneFitRecord& record,
                                std::span<const ColumnParameter> shown) {
  const SceneFitResult& result = record.result;
  const bool fitted = result.status == FitStatus::Fitted;
  std::vector<std::string> cells = {printable(record.name)};
  for (const ColumnParameter& parameter : shown) {
    const FittedParameter* found = result.find_parameter(parameter.path);
    const bool there = fitted && found != nullptr && found->verdict() != Verdict::NotIdentified;
    cells.push_back(there ? value_text(*found, parameter.unit) : "-");
  }
  cells.push_back(fitted ? significant(100.0 * largest_misfit(result), 2) : "-");
  cells.push_back(fitted ? flags_of(result) : std::string(word_of(result.status)));
  return cells;
}

std::string table_text(std::span<const SceneFitRecord> records,
                       std::span<const ColumnParameter> all, const ReportOptions& options,
                       const Ink& ink) {
  const auto shown = all.first(std::min(all.size(), kMaxColumns));
  std::vector<Table::Column> columns = {{"fit", Align::Left, ""}};
  for (const ColumnParameter& parameter : shown) {
    columns.push_back({short_name(parameter.path) + " ± error", Align::PlusMinus,
                       std::string(parameter.unit.name)});
  }
  columns.push_back({"misfit", Align::Right, "%"});
  columns.push_back({"flags", Align::Left, ""});
  Table table(std::move(columns));
  const std::size_t limit = options.specimens_shown == 0
                                ? records.size()
                                : std::max<std::size_t>(options.specimens_shown, 2);
  const std::size_t left_out = records.size() > limit ? records.size() - limit : 0;
  const std::size_t head = left_out > 0 ? limit / 2 : records.size();
  std::string seen;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (i == head) {
      table.add_line(fmt::format("… {} left out …", counted(left_out, "fit")));
      i += left_out;
    }
    if (records[i].result.status == FitStatus::Fitted) seen += flags_of(records[i].result);
    table.add(row_of(records[i], shown));
  }
  std::string text = ink.heading("Fits\n") + table.text(2, kWidth);
  const std::string flags = legend_of(scene_fit_flags(), seen);
  const std::string legend =
      "misfit: rms residual over the largest ordinate" + (flags.empty() ? flags : "; " + flags);
  return text + wrapped("  ", legend, kWidth);
}

/// Numbers of one row with the same decimals, those that the scatter says something of.
std::string with_decimals(double value, double scatter, double mean) {
  if (!std::isfinite(value)) return "-";
  if (!(scatter > 0.0)) return significant(value);
  if (std::fabs(mean) >= 1e7 || std::fabs(mean) <= 1e-4) return significant(value, 4);
  return fmt::format("{:.{}f}", value, decimals_for(mean, scatter, 3));
}

/// Intervals of mean and deviation, the latter "-" of few fits.
std::string population_intervals_text(const ScenePopulation& population,
                                      std::span<const ColumnParameter> shown, double confidence) {
  const std::string of = fmt::format("{:.4g} % interval", 100.0 * confidence);
  Table table({{"", Align::Left},
               {"mean", Align::Range, of},
               {"std. dev. of specimens", Align::Range, of},
               {"", Align::Left}});
  bool has_scatter = false;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PopulationParameter& p = population.parameters[i];
    const DisplayUnit& unit = shown[i].unit;
    const auto range = [&](double low, double high) {
      const auto number = [&](double value) {
        return with_decimals(value / unit.scale, (high - low) / unit.scale, p.mean / unit.scale);
      };
      return number(low) + " … " + number(high);
    };
    if (!std::isfinite(p.mean_low)) continue;
    has_scatter = has_scatter || std::isfinite(p.deviation_low);
    table.add({short_name(p.path), range(p.mean_low, p.mean_high),
               std::isfinite(p.deviation_low) ? range(p.deviation_low, p.deviation_high) : "-",
               std::string(unit.name)});
  }
  if (table.rows() == 0) return {};
  const bool is_shared = std::ranges::any_of(
      population.parameters, [](const PopulationParameter& p) { return p.sampling_error > 0.0; });
  return '\n' + table.text(2, kWidth) +
         wrapped("  ",
                 fmt::format("mean: Student's t, of {} fits and more bootstrap-t{}{}; {} resamples",
                             kFewestToDraw,
                             is_shared ? ", of breaks between the same two samples also their "
                                         "place between these"
                                       : "",
                             has_scatter ? "; deviation: chi-squared" : "", kPopulationResamples),
                 kWidth);
}

/// Whose values a population has: of the material, or of its beams.
std::string values_text(const ScenePopulation& population, std::span<const ColumnParameter> shown) {
  std::string material;
  std::string beams;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PopulationParameter& p = population.parameters[i];
    if (p.n < 2) continue;
    if (!p.is_of_material) {
      beams += (beams.empty() ? "" : ", ") + short_name(p.path);
      continue;
    }
    material +=
        fmt::format("{}{} ± {} {}", material.empty() ? "" : ", ", short_name(p.path),
                    significant(p.segments_error / shown[i].unit.scale, 2), shown[i].unit.name);
  }
  std::string text;
  if (!material.empty()) {
    text +=
        "of the material, extrapolated from the beams' segments, which shift all alike by up "
        "to: " +
        material + "; what lack of fit does to all alike is not in it";
  }
  if (!beams.empty()) {
    text += fmt::format(
        "{}of the values of these beams, with what segments and lack of fit do to "
        "all alike: {}",
        text.empty() ? "" : "; ", beams);
  }
  return text.empty() ? text : wrapped("  ", text, kWidth);
}

std::string population_text(const ScenePopulation& population,
                            std::span<const ColumnParameter> shown, double confidence,
                            const Ink& ink) {
  Table table({{"", Align::Left},
               {"n", Align::Right},
               {"mean ± error", Align::PlusMinus},
               {"std. dev.", Align::Right, "of values"},
               {"noise", Align::Right, "of fits"},
               {"std. dev.", Align::Right, "of specimens"},
               {"", Align::Left}});
  std::size_t left_out = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const PopulationParameter& p = population.parameters[i];
    left_out += p.left_out;
    if (p.n < 2) continue;
    const DisplayUnit& unit = shown[i].unit;
    const double mean = p.mean / unit.scale;
    const double scatter = p.standard_deviation / unit.scale;
    const auto number = [&](double value) {
      return with_decimals(value / unit.scale, scatter, mean);
    };
    table.add({short_name(p.path), std::to_string(p.n),
               with_error(mean, std::hypot(scatter / std::sqrt(static_cast<double>(p.n)),
                                           p.sampling_error / unit.scale)),
               number(p.standard_deviation), number(p.rms_error), number(p.specimen_deviation),
               std::string(unit.name)});
  }
  if (table.rows() == 0) return {};
  std::string text = '\n' + ink.heading("Population\n") + table.text(2, kWidth);
  text += wrapped("  ",
                  "of specimens: variance of the values less the mean of their squared errors of "
                  "noise and sampling, at least 0",
                  kWidth);
  text += values_text(population, shown);
  if (left_out > 0) {
    text += wrapped("  ", counted(left_out, "value") + " at a bound or not identified left out",
                    kWidth);
  }
  text += population_intervals_text(population, shown, confidence);
  Table pairs({{"", Align::Left}, {"", Align::Right}});
  for (std::size_t a = 0; a < shown.size(); ++a) {
    for (std::size_t b = a + 1; b < shown.size(); ++b) {
      const double value = population.correlation(a, b);
      if (std::isnan(value)) continue;
      pairs.add({short_name(shown[a].path) + ", " + short_name(shown[b].path),
                 fmt::format("{:+.2f}", value)});
    }
  }
  if (pairs.rows() == 0) return text;
  return text + '\n' + ink.heading("Correlations among specimens\n") + pairs.text(2, kWidth);
}

std::string failures_text(std::span<const SceneFitRecord> records, const Ink& ink) {
  std::string list;
  for (const SceneFitRecord& record : records) {
    if (record.result.status == FitStatus::Fitted) continue;
    list += wrapped(fmt::format("  {}: ", printable(record.name)), printable(record.result.reason),
                    kWidth);
  }
  if (!list.empty()) list = '\n' + ink.bad("Failed\n") + list;
  std::string unusable;
  for (const SceneFitRecord& record : records) {
    const std::string why = why_unusable(record.result);
    if (why.empty()) continue;
    unusable += wrapped(fmt::format("  {}: ", printable(record.name)), why, kWidth);
  }
  return unusable.empty() ? list : list + '\n' + ink.bad("No usable fit\n") + unusable;
}

}  // namespace

std::string scene_fits_report(std::span<const SceneFitRecord> records,
                              const ReportOptions& options) {
  const Ink ink(options.color);
  const ScenePopulation population = scene_population(records, options.confidence);
  const std::vector<ColumnParameter> shown = column_parameters(records, population);
  std::string text;
  if (records.size() == 1) {
    text = scene_fit_report(records.front(), options);
  } else if (!records.empty()) {
    text = table_text(records, shown, options, ink) +
           population_text(population, shown, options.confidence, ink) +
           failures_text(records, ink) + repairs_text(records, options, ink);
  }
  if (!text.empty()) text += '\n';
  const auto fitted = static_cast<std::size_t>(std::ranges::count(
      records, FitStatus::Fitted, [](const SceneFitRecord& r) { return r.result.status; }));
  const std::size_t failed = records.size() - fitted;
  const auto unusable = static_cast<std::size_t>(std::ranges::count_if(
      records, [](const SceneFitRecord& r) { return !why_unusable(r.result).empty(); }));
  const std::string last =
      fmt::format("fitted {}{}, failed {}\n", fitted, unusable_text(unusable), failed);
  return text + (failed + unusable == 0 ? ink.good(last) : ink.bad(last));
}

}  // namespace plastica::calibrate
