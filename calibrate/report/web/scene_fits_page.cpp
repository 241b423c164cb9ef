#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/web/fits_page.hpp"
#include "calibrate/report/web/group_blocks.hpp"
#include "calibrate/report/web/outcome_blocks.hpp"
#include "calibrate/report/web/page_parts.hpp"

namespace plastica::calibrate {
namespace {

using namespace report;
using plastica::report::web_text;
using plastica::report::WebPage;

WebTab detail_of(const SceneFitRecord& record, bool laws, const ReportOptions& options) {
  WebTab tab{label_of(record, laws), Json::array()};
  add_scene_figures(tab.blocks, record);
  add_warnings(tab, record.result.warnings);
  if (record.result.is_fitted()) {
    tab.blocks.push_back(parameters_block(record.result, options.confidence));
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
  table.add_numbers("misfit", "%",
                    "rms residual over the largest measured value, of the worst target");
  table.add_numbers("targets");
  table.add_words("flags");
  for (const SceneFitRecord& record : records) {
    const SceneFitResult& result = record.result;
    Json cells = {printable(record.name)};
    if (laws) cells.push_back(name_of(result.law));
    cells.push_back(verdict_of(result, why_unusable(result)));
    parameters.add_cells(result, cells);
    cells.push_back(result.is_fitted() ? number(100.0 * largest_misfit(result)) : Json(nullptr));
    cells.push_back(record.targets.size());
    cells.push_back(meanings_of(scene_fit_flags(), flags_of(result)));
    table.add_row(std::move(cells));
  }
  return table.block();
}

}  // namespace

WebPage fits_page(const SceneFitContents& contents, const std::string& file) {
  std::vector<SceneFitRecord> records = contents.records;
  const bool laws = compares_laws(records);
  const std::size_t advised = advised_first(records);
  const std::span<const SceneFitRecord> shown = std::span(records).first(advised);
  ReportOptions options;
  options.confidence = contents.confidence;
  WebPage page{file, {counts_line(shown)}};
  WebTab fits{"Fits", Json::array()};
  fits.blocks.push_back(scene_fits_block(records, laws));
  page.tabs.push_back(std::move(fits));
  if (laws) page.tabs.push_back(laws_tab(records, options));
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
