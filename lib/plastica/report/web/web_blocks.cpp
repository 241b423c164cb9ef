#include "plastica/report/web/web_blocks.hpp"

#include <array>
#include <string_view>

#include "plastica/report/web/packed_points.hpp"

namespace plastica::report {
namespace {

constexpr std::array<std::string_view, 6> kStrokes{"line", "dots",   "symbols",
                                                   "area", "points", "bars"};

}  // namespace

Json web_curve(const FigureCurve& curve, LogarithmicAxes logarithmic, int spots,
               const std::vector<std::string>& labels) {
  Json json = {{"name", curve.name},
               {"color", curve.color},
               {"stroke", kStrokes[static_cast<std::size_t>(curve.stroke)]}};
  if (curve.symbol != FigureCurve().symbol) json["symbol"] = curve.symbol;
  if (curve.dashes != 0) json["dashes"] = curve.dashes;
  const bool line = curve.stroke == Stroke::Line || curve.stroke == Stroke::Area;
  json["points"] =
      packed_points(curve.points, logarithmic, spots, line ? Thinning::Line : Thinning::Points);
  if (!labels.empty()) json["labels"] = labels;
  return json;
}

Json web_panel(const FigurePanel& panel, LogarithmicAxes logarithmic, Json curves) {
  Json json = {{"title", panel.title}, {"x", panel.x_label}, {"y", panel.y_label}};
  const auto range = [&](const char* name, const std::array<double, 2>& ends) {
    if (ends[0] != ends[1]) json[name] = {ends[0], ends[1]};
  };
  range("x_range", panel.x_range);
  range("y_range", panel.y_range);
  if (logarithmic[0] || logarithmic[1]) json["logarithmic"] = {logarithmic[0], logarithmic[1]};
  if (!panel.x_names.empty()) json["x_names"] = panel.x_names;
  if (!panel.marks.empty()) json["marks"] = numbers(panel.marks);
  if (!panel.mark_name.empty()) json["mark_name"] = panel.mark_name;
  for (const FigureNote& note : panel.notes) {
    json["notes"].push_back({{"x", number(note.x)}, {"y", number(note.y)}, {"text", note.text}});
  }
  json["curves"] = std::move(curves);
  return json;
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
  Json column = {{"name", std::move(name)}};
  if (!unit.empty()) column["unit"] = std::move(unit);
  columns_.push_back(std::move(column));
}

void WebTable::add_numbers(std::string name, std::string unit, std::string about, int digits) {
  add_words(std::move(name), std::move(unit));
  Json& column = columns_.back();
  column["numbers"] = true;
  if (!about.empty()) column["about"] = std::move(about);
  if (digits != 5) column["digits"] = digits;
}

Json WebTable::block() const {
  Json json = {{"kind", "table"},
               {"title", title_},
               {"columns", columns_},
               {"rows", rows_},
               {"opens", opens_}};
  if (!details_.empty()) json["details"] = details_;
  return json;
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
