#include "calibrate/report/web/fits_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/report/web/group_blocks.hpp"
#include "calibrate/report/web/outcome_blocks.hpp"
#include "calibrate/report/web/specimen_figure.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::web_facts;
using plastica::report::web_figure;
using plastica::report::web_notes;
using plastica::report::web_text;
using plastica::report::WebPage;
using plastica::report::WebTab;

/// Of more specimens the text of each report is left out, and curves are coarser: a page of ten
/// thousand is to stay below some sixty megabytes.
constexpr std::size_t kMostTexts = 200;
constexpr std::size_t kMostRaw = 1000;  ///< curves as they were read, beside the corrected ones
constexpr std::size_t kSpotsOfAll = 1'000'000;

int spots_for(std::size_t specimens) {
  const std::size_t each = kSpotsOfAll / std::max<std::size_t>(1, specimens);
  return static_cast<int>(std::clamp<std::size_t>(each, 200, 1500));
}

/// "identified", or what is not: "no usable fit: …", "break_strain weak".
std::string verdict_of(const FitOutcome& fit, const std::string& why_unusable) {
  if (!fit.is_fitted()) return std::string(word_of(fit.status));
  if (!why_unusable.empty()) return "no usable fit";
  std::string words;
  for (const FittedParameter* p : fit.free_parameters()) {
    if (p->verdict() == Verdict::Identified) continue;
    words += (words.empty() ? "" : ", ") + p->name() + " " + std::string(word_of(p->verdict()));
  }
  return words.empty() ? "identified" : words;
}

std::vector<std::string> warnings_of(const FitRecord& record) {
  std::vector<std::string> all = record.target.warnings;
  all.insert(all.end(), record.result.warnings.begin(), record.result.warnings.end());
  return all;
}

void add_warnings(WebTab& tab, const std::vector<std::string>& warnings) {
  if (!warnings.empty()) tab.blocks.push_back(web_notes("Warnings", warnings, "warning"));
}

template <typename Record>
std::vector<const FitOutcome*> outcomes_of(const std::vector<Record>& records) {
  std::vector<const FitOutcome*> fits;
  fits.reserve(records.size());
  for (const Record& record : records) fits.push_back(&record.result);
  return fits;
}

/// The keys of groups that any specimen has, in their order.
std::vector<std::string> group_keys(const std::vector<FitRecord>& records) {
  std::vector<std::string> keys;
  for (const FitRecord& record : records) {
    for (const auto& [key, value] : record.target.group) {
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  return keys;
}

std::string group_of(const FitRecord& record, const std::string& key) {
  for (const auto& [name, value] : record.target.group) {
    if (name == key) return value;
  }
  return {};
}

Json specimens_block(const std::vector<FitRecord>& records, bool laws) {
  const std::vector<std::string> keys = group_keys(records);
  const std::vector<const FitOutcome*> fits = outcomes_of(records);
  const WebParameters parameters(fits);
  const DisplayUnit percent = plastica::report::display_unit(Dimension::Strain, 1.0);
  WebTable table("");
  table.open_details();
  table.add_words("specimen");
  if (laws) table.add_words("law");
  for (const std::string& key : keys) table.add_words(key);
  table.add_words("verdict");
  parameters.add_to(table);
  table.add_numbers("misfit", "%", "rms residual over the largest measured stress");
  std::vector<DisplayUnit> units;
  for (const CharacteristicEntry& entry : characteristic_entries()) {
    double largest = 0.0;
    for (const FitRecord& record : records) {
      largest = std::max(
          largest, std::fabs(shown(entry, record.target.characteristics).value_or(0.0)));
    }
    units.push_back(plastica::report::display_unit(entry.dimension, largest,
                                                   entry.name == "youngs_modulus"));
    table.add_numbers(std::string(entry.label), std::string(units.back().name),
                      "of the measured curve: " + std::string(entry.name));
  }
  table.add_numbers("warnings");
  for (const FitRecord& record : records) {
    Json cells = {printable(record.name())};
    if (laws) cells.push_back(name_of(record.result.law));
    for (const std::string& key : keys) cells.push_back(group_of(record, key));
    cells.push_back(verdict_of(record.result, why_unusable(record.result)));
    parameters.add_cells(record.result, cells);
    cells.push_back(record.result.is_fitted() ? in_unit(record.result.misfit_fraction, percent)
                                              : Json(nullptr));
    for (std::size_t c = 0; c < units.size(); ++c) {
      cells.push_back(
          in_unit(shown(characteristic_entries()[c], record.target.characteristics), units[c]));
    }
    cells.push_back(warnings_of(record).size());
    table.add_row(std::move(cells));
  }
  return table.block();
}

Json facts_of_fit(const FitRecord& record) {
  const FitResult& result = record.result;
  const Target& target = record.target;
  const std::string unusable = why_unusable(result);
  return web_facts(
      "", {{"verdict", verdict_of(result, unusable)},
           {"why", unusable.empty() ? reason_of(record) : unusable},
           {"file", target.file},
           {"group", target.group.empty() ? "" : group_label(target.group)},
           {"test", fmt::format("{}, {}, {}", word_of(target.test), word_of(target.loading),
                                word_of(target.measure))},
           {"law", std::string(name_of(result.law))},
           {"misfit", result.is_fitted() ? fmt::format("{} % of the largest stress, {}",
                                                       significant(100.0 * result.misfit_fraction, 3),
                                                       result.misfit_word)
                                         : ""},
           {"samples", fmt::format("{} of {} in the fit", result.samples, target.raw.size())},
           {"evaluations", std::to_string(result.evaluations())},
           {"seed", std::to_string(result.seed)}});
}

/// What was done to the curve before the fit.
Json treatment_block(const Target& target) {
  WebTable table("What was done to the curve");
  table.add_words("what");
  table.add_numbers("amount");
  table.add_words("unit");
  table.add_words("why");
  for (const Repair& repair : target.repairs) {
    table.add_row({repair.kind, repair.count, "samples", repair.text});
  }
  for (const Correction& c : target.corrections) {
    table.add_row({c.applied ? c.kind : c.kind + " (not done)", number(c.amount), c.unit, c.text});
  }
  return table.is_empty() ? Json(nullptr) : table.block();
}

void add_block(WebTab& tab, Json block) {
  if (!block.is_null()) tab.blocks.push_back(std::move(block));
}

WebTab detail_of(const FitRecord& record, bool laws, std::size_t count) {
  WebTab tab{label_of(record, laws), Json::array()};
  const bool with_raw = count <= kMostRaw;
  tab.blocks.push_back(web_figure(specimen_figure(record, with_raw), spots_for(count)));
  tab.blocks.push_back(facts_of_fit(record));
  add_warnings(tab, warnings_of(record));
  if (record.result.is_fitted()) {
    tab.blocks.push_back(parameters_block(record.result));
    add_block(tab, correlations_block(record.result, record.result.correlated_parameters()));
  }
  add_intervals(tab.blocks, record.result, record.name());
  add_block(tab, treatment_block(record.target));
  if (count <= kMostTexts) tab.blocks.push_back(web_text("Report", fit_report(record)));
  return tab;
}

/// "5 fitted, 1 rejected, 0 failed; 1 of no use"
template <typename Record>
std::string counts_line(const std::vector<Record>& records) {
  std::map<std::string, std::size_t> counts;
  std::size_t unusable = 0;
  std::size_t warned = 0;
  for (const Record& record : records) {
    ++counts[std::string(word_of(record.result.status))];
    if (record.result.is_fitted() && !is_usable(record.result)) ++unusable;
    if (!record.result.warnings.empty()) ++warned;
  }
  std::string line;
  for (const auto& [word, count] : counts) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, word);
  }
  if (unusable > 0) line += fmt::format("; {} of no use", unusable);
  if (warned > 0) line += fmt::format("; {} with warnings", warned);
  return line;
}

template <typename Record>
WebTab laws_tab(const std::vector<Record>& records) {
  WebTab tab{"Laws", Json::array()};
  tab.blocks.push_back(web_text("Laws beside each other", laws_report(records)));
  return tab;
}

WebTab detail_of(const SceneFitRecord& record, bool laws, const ReportOptions& options) {
  WebTab tab{label_of(record, laws), Json::array()};
  add_scene_figures(tab.blocks, record);
  add_warnings(tab, record.result.warnings);
  if (record.result.is_fitted()) {
    tab.blocks.push_back(parameters_block(record.result));
    add_block(tab, correlations_block(record.result, record.result.correlated_parameters()));
  }
  add_intervals(tab.blocks, record.result, record.name);
  tab.blocks.push_back(web_text("Report", scene_fit_report(record, options)));
  return tab;
}

double largest_misfit(const SceneFitResult& result) {
  double largest = 0.0;
  for (const TargetFit& target : result.targets) {
    largest = std::max(largest, target.misfit_fraction);
  }
  return largest;
}

Json scene_fits_block(const std::vector<SceneFitRecord>& records, bool laws) {
  const std::vector<const FitOutcome*> fits = outcomes_of(records);
  const WebParameters parameters(fits);
  WebTable table("");
  table.open_details();
  table.add_words("fit");
  if (laws) table.add_words("law");
  table.add_words("verdict");
  parameters.add_to(table);
  table.add_numbers("misfit", "%", "rms residual over the largest measured value, of the worst target");
  table.add_numbers("targets");
  table.add_numbers("warnings");
  for (const SceneFitRecord& record : records) {
    const SceneFitResult& result = record.result;
    Json cells = {printable(record.name)};
    if (laws) cells.push_back(name_of(result.law));
    cells.push_back(verdict_of(result, why_unusable(result)));
    parameters.add_cells(result, cells);
    cells.push_back(result.is_fitted() ? number(100.0 * largest_misfit(result)) : Json(nullptr));
    cells.push_back(record.targets.size());
    cells.push_back(result.warnings.size());
    table.add_row(std::move(cells));
  }
  return table.block();
}

}  // namespace

WebPage fits_page(const FitStoreContents& contents, const std::string& file) {
  std::vector<FitRecord> records = contents.records;
  const bool laws = compares_laws(records);
  const std::size_t advised = advised_first(records);
  const std::span<const FitRecord> shown = std::span(records).first(advised);
  WebPage page{file, {counts_line(records)}};
  if (records.size() > kMostRaw) page.lines.emplace_back("curves as read are left out");
  WebTab specimens{"Specimens", Json::array()};
  specimens.blocks.push_back(specimens_block(records, laws));
  page.tabs.push_back(std::move(specimens));
  if (laws) page.tabs.push_back(laws_tab(records));
  const FitOptions& fit = contents.options;
  WebTab groups{"Groups", Json::array()};
  add_groups(groups.blocks, shown, {fit.intervals.specimens, fit.seed, fit.confidence});
  page.tabs.push_back(std::move(groups));
  page.tabs.push_back(
      plastica::report::provenance_tab(file, contents.meta, contents.inputs, contents.run));
  page.details.resize(records.size());
  parallel_for(records.size(), {}, [&](std::size_t i, int) {
    page.details[i] = plastica::report::part_text(detail_of(records[i], laws, records.size()));
  });
  return page;
}

WebPage fits_page(const SceneFitContents& contents, const std::string& file) {
  std::vector<SceneFitRecord> records = contents.records;
  const bool laws = compares_laws(records);
  const std::size_t advised = advised_first(records);
  const std::span<const SceneFitRecord> shown = std::span(records).first(advised);
  ReportOptions options;
  options.confidence = contents.confidence;
  WebPage page{file, {counts_line(records)}};
  WebTab fits{"Fits", Json::array()};
  fits.blocks.push_back(scene_fits_block(records, laws));
  page.tabs.push_back(std::move(fits));
  if (laws) page.tabs.push_back(laws_tab(records));
  WebTab all{"All fits", Json::array()};
  add_population(all.blocks, shown);
  all.blocks.push_back(web_text("Report", scene_fits_report(shown, options)));
  page.tabs.push_back(std::move(all));
  page.tabs.push_back(
      plastica::report::provenance_tab(file, contents.meta, contents.inputs, contents.run));
  for (const SceneFitRecord& record : records) {
    page.details.push_back(plastica::report::part_text(detail_of(record, laws, options)));
  }
  return page;
}

}  // namespace plastica::calibrate
