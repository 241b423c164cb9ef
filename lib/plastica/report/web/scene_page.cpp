#include "plastica/report/web/scene_page.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>

#include "plastica/report/format.hpp"
#include "plastica/report/scene_curves.hpp"
#include "plastica/report/scene_facts.hpp"
#include "plastica/report/scene_frames.hpp"
#include "plastica/report/scene_history.hpp"
#include "plastica/report/scene_plot.hpp"
#include "plastica/report/scene_text.hpp"
#include "plastica/report/web/web_beam.hpp"
#include "plastica/report/web/web_blocks.hpp"

namespace plastica::report {
namespace {

/// The curves of the pictures that there are of the record (`scene_plot_kinds`).
WebTab curves_tab(const io::SceneRecord& record) {
  const std::span<const io::SceneRecord> one(&record, 1);
  const auto kinds = scene_plot_kinds_of(record);
  const auto has = [&](std::string_view name) {
    return std::ranges::any_of(kinds, [&](const auto& kind) { return kind.name == name; });
  };
  WebTab tab{"Curves", Json::array()};
  const auto add = [&](std::string title, Figure figure) {
    figure.title = std::move(title);
    tab.blocks.push_back(web_figure(figure));
  };
  if (has("history")) {
    Figure all;
    for (const Probe& probe : record.setup.scene.probes) {
      for (FigurePanel& panel : history_figure(one, probe.name).panels) {
        all.panels.push_back(std::move(panel));
      }
    }
    add("Histories", std::move(all));
  }
  if (has("load")) add("Load", load_figure(one, ""));
  if (has("joint")) add("Stress and strain", joint_figure(one, {}));
  if (has("energy")) add("Energies", energy_figure(record, is_motion(record)));
  if (has("spectrum")) add("Spectrum", spectrum_figure(one, "", false));
  return tab;
}

}  // namespace

WebPage scene_page(const io::SceneRecord& record, const std::string& file) {
  WebPage page{printable(record.setup.scene.name)};
  page.lines.push_back(outcome_line(record));
  const auto warnings = [&](WebTab& tab) {
    if (!record.warnings.empty()) {
      tab.blocks.push_back(web_notes("Warnings", record.warnings, "warning"));
    }
  };
  if (record.response.chain.joints > 0 && frames_of(record) > 0) {
    WebTab beam{"Beam", Json::array()};
    warnings(beam);
    beam.blocks.push_back(web_beam(record));
    page.tabs.push_back(std::move(beam));
  }
  WebTab curves = curves_tab(record);
  if (page.tabs.empty()) warnings(curves);
  if (!curves.blocks.empty()) page.tabs.push_back(std::move(curves));
  WebTab text{"Report", Json::array()};
  text.blocks.push_back(web_text("Report", scene_report(record)));
  page.tabs.push_back(std::move(text));
  page.tabs.push_back(provenance_tab(file, record.meta, record.inputs));
  return page;
}

}  // namespace plastica::report
