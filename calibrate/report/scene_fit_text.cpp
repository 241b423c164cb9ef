#include "calibrate/report/scene_fit_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "calibrate/inference/material_interval.hpp"
#include "calibrate/report/outcome_text.hpp"
#include "calibrate/report/parameter_words.hpp"
#include "calibrate/report/repairs_text.hpp"
#include "calibrate/report/scene_errors_text.hpp"
#include "calibrate/report/scene_fit_words.hpp"
#include "calibrate/report/shown_intervals.hpp"
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

std::string scene_entry(std::string_view label, std::string_view text) {
  return wrapped(fmt::format("  {:<12}", label), text, kWidth);
}

/// The costs in rising order, equal ones once: "best cost 7.10 in 2 of 3 searches, then 7.40".
std::string waterfall(const SceneFitResult& result) {
  constexpr std::size_t kMax = 5;
  const std::vector<double> costs = sorted_costs(result);
  const std::size_t searches = result.starts.size();
  if (costs.empty()) return fmt::format("{}, none with a curve", counted(searches, "start"));
  const std::size_t best = count_of_best(costs);
  std::string text = searches == 1 ? fmt::format("cost {}", significant(costs.front(), 4))
                                   : fmt::format("best cost {} from {} of {} starts",
                                                 significant(costs.front(), 4), best, searches);
  for (std::size_t i = best; i < costs.size() && i < best + kMax; ++i) {
    text += fmt::format("{} {}", i == best ? ", then" : ",", significant(costs[i], 4));
  }
  if (costs.size() > best + kMax) text += ", …";
  if (costs.size() < searches) text += fmt::format("; {} without a curve", searches - costs.size());
  return text + fmt::format(" ({})", name_of(result.outcome));
}

std::string header(const SceneFitRecord& record, const Ink& ink) {
  const SceneFitResult& result = record.result;
  const std::string unusable = why_unusable(result);
  const bool usable = result.is_fitted() && unusable.empty();
  std::string text = wrapped("",
                             fmt::format("{}: {}{}", printable(record.name), word_of(result.status),
                                         unusable.empty() ? "" : ", but no usable fit"),
                             kWidth);
  text = usable ? ink.heading(text) : ink.bad(text);
  const std::string& reason = unusable.empty() ? result.reason : unusable;
  if (!usable && !reason.empty()) text += scene_entry("reason", printable(reason));
  if (result.starts.empty()) return text;
  if (result.objective == Objective::Path) {
    text += scene_entry("objective", "path: a sample counts by the abscissa that it stands for");
  }
  text += scene_entry("search", waterfall(result));
  std::string work = counted(static_cast<std::size_t>(result.runs), "run") + " of scenes";
  if (result.failed_runs > 0) {
    work += fmt::format(", {} without a curve over the measured abscissa", result.failed_runs);
  }
  return text +
         scene_entry("work", work + fmt::format("; {:.3g} segment iterations",
                                                static_cast<double>(result.segment_iterations)));
}

/// Targets of a joint fit differ in how well their noise is known, and so do the parameters.
std::string noise_text(const SceneFitResult& result) {
  double min = std::numeric_limits<double>::infinity(), max = 0.0;
  for (const FittedParameter* p : result.free_parameters()) {
    min = std::min(min, p->degrees_of_freedom);
    max = std::max(max, p->degrees_of_freedom);
  }
  if (std::isinf(min)) return "noise as the targets state it";
  std::string degrees = significant(min, 3);
  if (significant(max, 3) != degrees) {
    degrees = std::isinf(max) ? fmt::format("at least {}", degrees)
                              : fmt::format("{} to {}", degrees, significant(max, 3));
  }
  return fmt::format("noise estimated from residuals, {} degrees of freedom", degrees);
}

/// "0.0290 ± 0.0005 m".
std::string break_text(const SceneTarget& target) {
  const DisplayUnit unit = plastica::report::display_unit(target.abscissa_is, target.broke->at);
  const double at = target.broke->at / unit.scale;
  const double half = target.broke->half_interval / unit.scale;
  return quantity(half > 0.0 ? with_error(at, half) : significant(at, 4), unit.name);
}

bool has_material_intervals(const SceneFitResult& result) {
  if (!result.segments || result.segments->parameters.size() != result.free_count()) {
    return false;
  }
  for (std::size_t i = 0; i < result.segments->parameters.size(); ++i) {
    if (is_of_material(result.parameters[i], result.segments->parameters[i])) return true;
  }
  return false;
}

std::string targets_text(const SceneFitRecord& record, const Ink& ink) {
  const std::vector<TargetFit>& targets = record.result.targets;
  if (record.result.status != FitStatus::Fitted || targets.size() != record.targets.size())
    return {};
  const bool broke = std::ranges::any_of(
      targets, [](const TargetFit& of_target) { return !std::isnan(of_target.break_strain); });
  const bool weighted =
      std::ranges::any_of(record.weights, [](double weight) { return weight != 1.0; });
  std::vector<Table::Column> columns = {{"", Align::Left},
                                        {"level", Align::Left},
                                        {"samples", Align::Right},
                                        {"noise", Align::Right},
                                        {"", Align::Left},
                                        {"misfit", Align::Right, "% of largest"},
                                        {"runs test", Align::Right, "p"}};
  const bool several_laws = has_several_laws(record.result);
  if (several_laws) columns.insert(columns.begin() + 1, {"law", Align::Left});
  if (weighted) columns.push_back({"weight"});
  if (broke) columns.push_back({"break strain", Align::Right, "%"});
  Table table(std::move(columns));
  for (std::size_t p = 0; p < targets.size(); ++p) {
    const TargetFit& of_target = targets[p];
    const SceneTarget& target = record.targets[p];
    const DisplayUnit unit = plastica::report::display_unit(target.ordinate_is, of_target.noise);
    std::vector<std::string> cells = {
        printable(of_target.name),
        std::string(word_of(of_target.level)),
        std::to_string(of_target.samples),
        significant(of_target.noise / unit.scale, 3),
        std::string(unit.name) + (target.noise ? " (stated)" : ""),
        significant(100.0 * of_target.misfit_fraction, 2),
        std::isnan(of_target.runs_test_p) ? "-" : fmt::format("{:.2g}", of_target.runs_test_p)};
    if (several_laws) cells.insert(cells.begin() + 1, std::string(name_of(of_target.law)));
    if (weighted) cells.push_back(brief(record.weights[p]));
    if (broke) {
      cells.push_back(std::isnan(of_target.break_strain)
                          ? "-"
                          : significant(100.0 * of_target.break_strain, 4));
    }
    table.add(std::move(cells));
    if (!target.broke) continue;
    std::string note = "broke at " + abscissa_text(target) + ' ' + break_text(target);
    if (target.broke->cut > 1)
      note += "; " + counted(target.broke->cut, "row") + " after it left out";
    table.add_note(std::move(note));
  }
  return '\n' + ink.heading("Targets\n") + table.text(2, kWidth);
}

}  // namespace

std::string scene_fit_report(const SceneFitRecord& record, const ReportOptions& options) {
  const Ink ink(options.color);
  const SceneFitResult& result = record.result;
  std::string text = header(record, ink) + repairs_text({&record, 1}, options, ink) +
                     parameters_text(result, options, ink);
  if (result.is_fitted() && !result.parameters.empty()) {
    text += scene_entry("errors", noise_text(result));
    if (has_material_intervals(result)) {
      text += scene_entry("interval",
                          "of the material: about the value that more segments lead to "
                          "(extrapolated), not about that of this beam");
    }
  }
  return text + intervals_text(shown_intervals(result), options) + errors_text(record, ink) +
         segments_text(record, ink) + targets_text(record, ink) +
         correlations_text(strong_correlations(result), ink) +
         warnings_text({&result.warnings}, ink);
}

}  // namespace plastica::calibrate
