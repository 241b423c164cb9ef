#include "sweeps/report/web/scan_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/format.hpp"
#include "plastica/report/scene_setup_text.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "plastica/run/path_stops.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/report/web/scan_figures.hpp"
#include "sweeps/stability/scene_scan_text.hpp"
#include "sweeps/stability/summary.hpp"

namespace plastica::sweeps::stability {
namespace {

using report::Json;
using report::WebPage;
using report::WebTab;

std::string shown_unit(std::string_view unit) {
  return unit == "1" ? std::string() : std::string(unit);
}

/// How far each field may go, and why no further.
Json fields_block(const SceneScan& scan, const SceneScanOptions& options) {
  report::WebTable table("How far each number may go, the others as they are");
  table.add_words("field");
  table.add_words("unit");
  table.add_numbers("from", "", "the last valid value below");
  table.add_numbers("value", "", "the scene's own");
  table.add_numbers("to", "", "the last valid value above");
  table.add_words("below that");
  table.add_words("above that");
  for (const ScannedField& one : scan.fields) {
    if (!one.matters()) continue;
    table.add_row({std::string(one.field->path), shown_unit(si_unit(one.field->dimension)),
                   report::number(one.below.value), report::number(one.value),
                   report::number(one.above.value), end_text(one.below, options),
                   end_text(one.above, options)});
  }
  return table.is_empty() ? Json(nullptr) : table.block();
}

std::string without_effect(const SceneScan& scan) {
  std::vector<std::string_view> names;
  for (const ScannedField& one : scan.fields) {
    if (!one.matters()) names.push_back(one.field->path);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Every point, as the CSV has it, and how far it is off a finer run.
Json points_block(const std::vector<const StabilityRow*>& rows) {
  const bool pairs =
      std::ranges::any_of(rows, [](const StabilityRow* row) { return row->at.size() > 1; });
  const std::size_t fields = pairs ? 2 : 1;
  report::WebTable table("");
  table.add_words("point");
  table.add_words("verdict");
  table.add_words("reason");
  table.add_numbers("deviation", "%", "from a finer run");
  table.add_words("of");
  for (std::size_t k = 0; k < fields; ++k) {
    const std::string number = k == 0 ? "" : " 2";
    table.add_words("field" + number);
    table.add_numbers("value" + number);
    table.add_words("unit" + number);
  }
  table.add_words("level");
  table.add_words("analysis");
  table.add_words("status");
  table.add_numbers("energy balance error", "", "", 3);
  table.add_numbers("segment steps", "", "segments times steps");
  table.add_numbers("time", "s", "", 3);
  for (const StabilityRow* row : rows) {
    Json cells = {
        row->id, kValidity[static_cast<std::size_t>(row->verdict.validity)], row->verdict.reason,
        row->deviation ? report::number(100.0 * *row->deviation) : Json(nullptr), row->quantity};
    for (std::size_t k = 0; k < fields; ++k) {
      const bool there = k < row->at.size();
      cells.push_back(there ? Json(row->at[k].axis) : Json(nullptr));
      cells.push_back(there ? report::number(row->at[k].value) : Json(nullptr));
      cells.push_back(there ? Json(shown_unit(row->at[k].unit)) : Json(nullptr));
    }
    cells.push_back(std::string(word_of(row->level)));
    cells.push_back(row->analysis == Analysis::Dynamics ? "dynamics" : "statics");
    cells.push_back(name_of(row->status));
    cells.push_back(report::number(row->energy_balance_error));
    cells.push_back(report::number(row->segment_steps));
    cells.push_back(report::number(row->seconds));
    table.add_row(std::move(cells));
  }
  return table.block();
}

/// "36 points run: 30 valid, 5 inaccurate, 1 failed, 0 undetected errors".
std::string counts_text(const std::vector<const StabilityRow*>& rows) {
  std::array<std::size_t, 4> counts{};
  for (const StabilityRow* row : rows) ++counts[static_cast<std::size_t>(row->verdict.validity)];
  return fmt::format("{} run: {} valid, {} inaccurate, {} failed, {} undetected {}",
                     report::counted(rows.size(), "point"), counts[0], counts[1], counts[2],
                     counts[3], counts[3] == 1 ? "error" : "errors");
}

WebTab fields_tab(const SceneScan& scan, const SceneScanOptions& options,
                  const io::SceneFile& file) {
  WebTab tab{"Fields", Json::array()};
  if (!scan.warnings.empty()) {
    tab.blocks.push_back(report::web_notes("Warnings", scan.warnings, "warning"));
  }
  tab.blocks.push_back(report::web_facts(
      "The scene as it is",
      {{"own values", own_verdict_text(scan)},
       {"valid up to", fmt::format("{:g} % off a finer run", 100.0 * options.within)},
       {"change no probe", scan.complete ? without_effect(scan) : ""}}));
  // Of fields that were not followed to their ends nothing can be said.
  if (scan.complete) {
    Json fields = fields_block(scan, options);
    if (!fields.is_null()) tab.blocks.push_back(std::move(fields));
  }
  const Scene& scene = file.setup.scene;
  io::SceneRecord record = io::make_scene_record(file, prepare(scene, file.setup.solver), {});
  // How large loads become is said of the end.
  record.response.chain.time = {path_stops(scene, file.setup.solver).time.back()};
  tab.blocks.push_back(report::web_text("Scene", report::setup_text(record)));
  return tab;
}

}  // namespace

WebPage scan_page(const SceneScan& scan, std::span<const StabilityRow> pair,
                  const SceneScanOptions& options, const io::SceneFile& file,
                  const io::RunMeta& meta) {
  std::vector<const StabilityRow*> rows;
  for (const StabilityRow& row : scan.rows) rows.push_back(&row);
  for (const StabilityRow& row : pair) rows.push_back(&row);
  WebPage page{report::printable(scan.scene),
               {fmt::format("own values {}", own_verdict_text(scan)), counts_text(rows)}};
  page.numbers_in = "the table of points";
  if (!scan.complete) {
    page.lines.emplace_back("interrupted: fields were not followed to their ends");
  } else if (is_raised(options.stop)) {
    page.lines.emplace_back("interrupted: the map lacks points");
  }
  page.tabs.push_back(fields_tab(scan, options, file));
  WebTab pictures{"Pictures", Json::array()};
  // Shown before the fields: it is what was asked for.
  if (!pair.empty()) {
    pictures.blocks.push_back(pair_figure(pair, scan.fields[0], scan.fields[1]));
  }
  Json deviations = scan.complete ? deviation_figure(scan, options) : Json(nullptr);
  if (!deviations.is_null()) pictures.blocks.push_back(std::move(deviations));
  if (!pictures.blocks.empty()) page.tabs.push_back(std::move(pictures));
  WebTab points{"Points", Json::array()};
  points.blocks.push_back(points_block(rows));
  page.tabs.push_back(std::move(points));
  if (scan.complete) {
    WebTab text{"Report", Json::array()};
    text.blocks.push_back(report::web_text("Report", scene_scan_text(scan, options)));
    page.tabs.push_back(std::move(text));
  }
  page.tabs.push_back(report::provenance_tab(
      "", meta, {{std::filesystem::path(file.path).filename().string(), file.text}}));
  return page;
}

}  // namespace plastica::sweeps::stability
