#include "plastica/report/web/web_blocks.hpp"

#include <array>
#include <string_view>

#include "plastica/report/web/packed_points.hpp"

namespace plastica::report {
namespace {

constexpr std::array<std::string_view, 6> kStrokes{"line", "dots",   "symbols",
                                                   "area", "points", "bars"};

/// Null where both ends are the same: as far as the curves go.
Json range_of(const std::array<double, 2>& range) {
  return range[0] == range[1] ? Json(nullptr) : Json{range[0], range[1]};
}

}  // namespace

Json web_curve(const FigureCurve& curve, LogarithmicAxes logarithmic, int spots,
               const std::vector<std::string>& labels) {
  Json json = {{"name", curve.name},
               {"color", curve.color},
               {"stroke", kStrokes[static_cast<std::size_t>(curve.stroke)]},
               {"symbol", curve.symbol},
               {"dashes", curve.dashes},
               {"points", packed_points(curve.points, logarithmic, spots)}};
  if (!labels.empty()) json["labels"] = labels;
  return json;
}

Json web_panel(const FigurePanel& panel, LogarithmicAxes logarithmic, Json curves) {
  Json notes = Json::array();
  for (const FigureNote& note : panel.notes) {
    notes.push_back({{"x", number(note.x)}, {"y", number(note.y)}, {"text", note.text}});
  }
  return {{"title", panel.title},
          {"x", panel.x_label},
          {"y", panel.y_label},
          {"logarithmic", logarithmic},
          {"x_range", range_of(panel.x_range)},
          {"y_range", range_of(panel.y_range)},
          {"x_names", panel.x_names},
          {"marks", numbers(panel.marks)},
          {"mark_name", panel.mark_name},
          {"notes", std::move(notes)},
          {"curves", std::move(curves)}};
}

Json web_panels(std::string title, Json panels) {
  return {{"kind", "figure"}, {"title", std::move(title)}, {"panels", std::move(panels)}};
}

Json web_text(std::string title, std::string text) {
  return {{"kind", "text"}, {"title", std::move(title)}, {"text", std::move(text)}};
}

Json web_notes(std::string title, const std::vector<std::string>& notes, std::string tone) {
  return {
      {"kind", "notes"}, {"title", std::move(title)}, {"notes", notes}, {"tone", std::move(tone)}};
}

Json web_facts(std::string title, const std::vector<std::pair<std::string, std::string>>& facts) {
  Json rows = Json::array();
  for (const auto& [name, what] : facts) {
    if (!what.empty()) rows.push_back({name, what});
  }
  return {{"kind", "facts"}, {"title", std::move(title)}, {"rows", std::move(rows)}};
}

void WebTable::add_words(std::string name, std::string unit) {
  columns_.push_back({{"name", std::move(name)}, {"unit", std::move(unit)}, {"numbers", false}});
}

void WebTable::add_numbers(std::string name, std::string unit, std::string about, int digits) {
  columns_.push_back({{"name", std::move(name)},
                      {"unit", std::move(unit)},
                      {"numbers", true},
                      {"about", std::move(about)},
                      {"digits", digits}});
}

Json WebTable::block() const {
  return {
      {"kind", "table"}, {"title", title_}, {"columns", columns_}, {"rows", rows_}, {"opens", opens_}};
}

Json web_figure(const Figure& figure, int spots) {
  Json panels = Json::array();
  for (const FigurePanel& panel : figure.panels) {
    const LogarithmicAxes logarithmic{false, panel.logarithmic};
    Json curves = Json::array();
    for (const FigureCurve& curve : panel.curves) {
      curves.push_back(web_curve(curve, logarithmic, spots));
    }
    panels.push_back(web_panel(panel, logarithmic, std::move(curves)));
  }
  return web_panels(figure.title, std::move(panels));
}

}  // namespace plastica::report
