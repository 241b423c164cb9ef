#include "sweeps/report/web/web_map.hpp"

#include <utility>

#include "plastica/report/format.hpp"

namespace plastica::sweeps {
namespace {

using report::Json;

Json class_of(const CaseClass& one) {
  Json json = {{"name", one.name}};
  if (one.fraction) json["fraction"] = *one.fraction;
  return json;
}

Json map_cells(const CaseMap& map, const MapPanel& panel, const SweepRecord& record) {
  Json cells = Json::array();
  for (const std::size_t i : panel.cases) {
    if (!map.classes.class_of[i]) continue;
    cells.push_back({{"x", map.x.at(map.x.of(record, i))},
                     {"y", map.y.at(map.y.of(record, i))},
                     {"class", *map.classes.class_of[i]},
                     {"number", map.classes.number[i]},
                     {"amount", report::number(map.classes.amount[i])},
                     {"case", i}});
  }
  return cells;
}

}  // namespace

Json web_map(std::string title, const CaseMap& map, const SweepRecord& record, bool opens) {
  Json json = {{"kind", "map"},
               {"title", std::move(title)},
               {"what", map.classes.what},
               {"x", map.x.label},
               {"y", map.y.label},
               {"x_values", report::numbers(map.x.values)},
               {"y_values", report::numbers(map.y.values)},
               {"opens", opens},
               {"classes", Json::array()},
               {"maps", Json::array()}};
  if (!map.limits.empty()) json["limits"] = map.limits;
  for (const CaseClass& one : map.classes.classes) json["classes"].push_back(class_of(one));
  for (const MapPanel& panel : map.panels) {
    json["maps"].push_back({{"title", panel.title}, {"cells", map_cells(map, panel, record)}});
  }
  return json;
}

}  // namespace plastica::sweeps
