#include "calibrate/report/web/fits_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "calibrate/report/fit_flags.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/plot_parts.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/summary.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/report/text_groups.hpp"
#include "calibrate/report/web/group_blocks.hpp"
#include "calibrate/report/web/outcome_blocks.hpp"
#include "calibrate/report/web/page_parts.hpp"
#include "calibrate/report/web/specimen_figure.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::web_facts;
using plastica::report::web_figure;
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

std::vector<std::string> warnings_of(const FitRecord& record) {
  std::vector<std::string> all = record.target.warnings;
  all.insert(all.end(), record.result.warnings.begin(), record.result.warnings.end());
  return all;
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
      largest =
          std::max(largest, std::fabs(shown(entry, record.target.characteristics).value_or(0.0)));
    }
    units.push_back(
        plastica::report::display_unit(entry.dimension, largest, entry.name == "youngs_modulus"));
    table.add_numbers(characteristic_label(entry.name, records), std::string(units.back().name),
                      "of the measured curve: " + std::string(entry.name));
  }
  table.add_words("flags");
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
    cells.push_back(meanings_of(fit_flags(), flags_of(record)));
    table.add_row(std::move(cells));
  }
  return table.block();
}

Json facts_of_fit(const FitRecord& record) {
  const FitResult& result = record.result;
  const Target& target = record.target;
  const std::string unusable = why_unusable(result);
  return web_facts(
      "",
      {{"verdict", verdict_of(result, unusable)},
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
       {"samples", fmt::format("{} of {} in the fit", result.samples, target.raw.samples())},
       {"evaluations", std::to_string(result.evaluations())},
       {"seed", std::to_string(result.seed)}});
}

/// What was done to the curve before the fit.
Json treatment_block(const Target& target) {
  WebTable table("What was done to the curve");
  table.add_words("what");
  table.add_words("size");
  table.add_words("why");
  for (const Repair& repair : target.repairs) {
    table.add_row({repair.kind, counted(repair.count, "sample"), repair.text});
  }
  for (const Correction& c : target.corrections) {
    if (c.applied) {
      table.add_row({c.kind, size_of(c), c.text});
    } else {
      table.add_row({c.kind + " (not done)", nullptr, c.text});
    }
  }
  return table.is_empty() ? Json(nullptr) : table.block();
}

WebTab detail_of(const FitRecord& record, bool laws, std::size_t count,
                 const ReportOptions& options) {
  WebTab tab{label_of(record, laws), Json::array()};
  const bool with_raw = count <= kMostRaw;
  tab.blocks.push_back(web_figure(specimen_figure(record, with_raw), spots_for(count)));
  tab.blocks.push_back(facts_of_fit(record));
  add_warnings(tab, warnings_of(record));
  if (record.result.is_fitted()) {
    tab.blocks.push_back(parameters_block(record.result, options.confidence));
    add_block(tab, correlations_block(record.result, record.result.correlated_parameters()));
  }
  add_intervals(tab.blocks, record.result, record.name());
  add_block(tab, treatment_block(record.target));
  if (count <= kMostTexts) tab.blocks.push_back(web_text("Report", fit_report(record, options)));
  return tab;
}

}  // namespace

WebPage fits_page(const FitStoreContents& contents, const std::string& file) {
  report::require_curves(contents.records);
  std::vector<FitRecord> records = contents.records;
  const FitOptions& fit = contents.options;
  ReportOptions options;
  options.confidence = fit.confidence;
  options.specimen_resamples = fit.intervals.specimens;
  options.seed = fit.seed;
  const bool laws = compares_laws(records);
  const std::size_t advised = advised_first(records);
  const std::span<const FitRecord> shown = std::span(records).first(advised);
  WebPage page{file, {counts_line(shown)}};
  if (records.size() > kMostTexts) {
    page.lines.push_back(
        fmt::format("of more than {} specimens the text of each report is left out, of more than "
                    "{} the curve as it "
                    "was read",
                    kMostTexts, kMostRaw));
  }
  WebTab specimens{"Specimens", Json::array()};
  specimens.blocks.push_back(specimens_block(records, laws));
  page.tabs.push_back(std::move(specimens));
  if (laws) page.tabs.push_back(laws_tab(records, options));
  WebTab groups{"Groups", Json::array()};
  add_groups(groups.blocks, shown, {fit.intervals.specimens, fit.seed, fit.confidence});
  page.tabs.push_back(std::move(groups));
  page.tabs.push_back(
      plastica::report::provenance_tab(file, contents.meta, contents.inputs, contents.run));
  page.details.resize(records.size());
  parallel_for(records.size(), {}, [&](std::size_t i, int) {
    page.details[i] =
        plastica::report::part_text(detail_of(records[i], laws, records.size(), options));
  });
  return page;
}

}  // namespace plastica::calibrate
