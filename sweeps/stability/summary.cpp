#include "sweeps/stability/summary.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "plastica/report/format.hpp"
#include "sweeps/stability/scan.hpp"

namespace plastica::sweeps::stability {
namespace {

const BaseScene& scene_of(const StabilityRow& row) {
  const auto scenes = base_scenes();
  return *std::find_if(scenes.begin(), scenes.end(),
                       [&](const BaseScene& scene) { return scene.name == row.scene; });
}

/// The points of one scene along one axis, by value.
struct Scan {
  const BaseScene* scene = nullptr;
  std::vector<std::pair<double, Validity>> points;
};

/// Where on a scan the normal value is; 0 where steps follow the period.
double normal_value(const BaseScene& scene, const Axis& axis) { return scene.normal.*axis.knob; }

struct Ends {
  double low;
  double high;
  bool open_low;
  bool open_high;
};

/// The valid range around a value; a scan without a normal value has its longest one.
std::optional<Ends> valid_range(const Scan& scan, double normal) {
  const auto& points = scan.points;
  std::optional<Ends> best;
  for (std::size_t i = 0; i < points.size();) {
    if (points[i].second != Validity::Valid) {
      ++i;
      continue;
    }
    std::size_t j = i;
    while (j + 1 < points.size() && points[j + 1].second == Validity::Valid) ++j;
    const Ends ends{points[i].first, points[j].first, i == 0, j + 1 == points.size()};
    const bool around = normal > 0.0 && ends.low <= normal && normal <= ends.high;
    const bool longer =
        !best || ends.high / std::max(ends.low, 1e-300) > best->high / std::max(best->low, 1e-300);
    if (around) return ends;
    if (longer) best = ends;
    i = j + 1;
  }
  return best;
}

std::string number(double value) { return report::brief(value); }

}  // namespace

std::string_view word_of(Level level) {
  switch (level) {
    case Level::Coupon: return "coupon";
    case Level::Twist: return "twist";
    case Level::Planar: return "planar";
    case Level::Spatial: return "spatial";
    case Level::Auto: break;
  }
  return "auto";
}

std::vector<LevelCount> count_validity(std::span<const StabilityRow> rows) {
  std::map<std::pair<int, int>, LevelCount> counts;
  for (const StabilityRow& row : rows) {
    if (!row.begun) continue;
    LevelCount& count = counts[{static_cast<int>(row.level), static_cast<int>(row.analysis)}];
    count.level = row.level;
    count.analysis = row.analysis;
    ++count.points[static_cast<std::size_t>(row.verdict.validity)];
  }
  std::vector<LevelCount> all;
  all.reserve(counts.size());
  for (const auto& [key, count] : counts) all.push_back(count);
  return all;
}

std::vector<SafeRange> safe_ranges(std::span<const StabilityRow> rows) {
  // By axis, level and analysis: the scan of each scene.
  std::map<std::tuple<std::size_t, int, int>, std::map<std::string, Scan>> scans;
  for (const StabilityRow& row : rows) {
    if (!row.begun || row.at.size() > 1) continue;
    const BaseScene& scene = scene_of(row);
    for (std::size_t a = 0; a < axes().size(); ++a) {
      const Axis& axis = axes()[a];
      if (std::find(scene.axes.begin(), scene.axes.end(), axis.name) == scene.axes.end()) continue;
      const bool here = !row.at.empty() && row.at[0].axis == axis.name;
      const double normal = normal_value(scene, axis);
      if (!here && (!row.at.empty() || normal <= 0.0)) continue;
      Scan& scan =
          scans[{a, static_cast<int>(row.level), static_cast<int>(row.analysis)}][row.scene];
      scan.scene = &scene;
      scan.points.emplace_back(here ? row.at[0].value : normal, row.verdict.validity);
    }
  }
  std::vector<SafeRange> ranges;
  for (auto& [key, scenes] : scans) {
    const Axis& axis = axes()[std::get<0>(key)];
    SafeRange range;
    range.level = static_cast<Level>(std::get<1>(key));
    range.analysis = static_cast<Analysis>(std::get<2>(key));
    range.axis = axis.name;
    range.unit = axis.unit;
    range.scenes = scenes.size();
    range.open_low = range.open_high = true;
    range.low = -std::numeric_limits<double>::infinity();
    range.high = std::numeric_limits<double>::infinity();
    for (auto& [name, scan] : scenes) {
      std::sort(scan.points.begin(), scan.points.end());
      const auto ends = valid_range(scan, normal_value(*scan.scene, axis));
      if (!ends) {
        range.low = 1.0;
        range.high = 0.0;
        break;
      }
      if (ends->low >= range.low) {
        range.open_low = ends->open_low;
        range.low = ends->low;
      }
      if (ends->high <= range.high) {
        range.open_high = ends->open_high;
        range.high = ends->high;
      }
    }
    ranges.push_back(range);
  }
  return ranges;
}

std::string summary_text(std::span<const StabilityRow> rows) {
  std::string text =
      "| level | points | valid | inaccurate | failed | undetected |\n|---|---|---|---|---|---|\n";
  std::array<std::size_t, 4> total{};
  const auto line = [&](const std::string& name, const std::array<std::size_t, 4>& points) {
    std::size_t sum = 0;
    for (const std::size_t count : points) sum += count;
    text += "| " + name + " | " + std::to_string(sum);
    for (const std::size_t count : points) text += " | " + std::to_string(count);
    text += " |\n";
  };
  for (const LevelCount& count : count_validity(rows)) {
    const bool moves = count.analysis == Analysis::Dynamics;
    const std::string name(word_of(count.level));
    line(count.level == Level::Coupon ? name : name + (moves ? ", dynamics" : ", statics"),
         count.points);
    for (std::size_t i = 0; i < total.size(); ++i) total[i] += count.points[i];
  }
  line("all", total);

  const std::vector<SafeRange> ranges = safe_ranges(rows);
  std::vector<std::pair<Level, Analysis>> columns;
  for (const LevelCount& count : count_validity(rows))
    columns.emplace_back(count.level, count.analysis);
  text += "\n| valid for all scenes |";
  for (const auto& [level, analysis] : columns) {
    text += " " + std::string(word_of(level)) +
            (level == Level::Coupon           ? ""
             : analysis == Analysis::Dynamics ? ", dynamics"
                                              : ", statics") +
            " |";
  }
  text += "\n|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---|";
  text += '\n';
  for (const Axis& axis : axes()) {
    text += "| " + std::string(axis.name) +
            (axis.unit == "1" ? "" : " [" + std::string(axis.unit) + "]") + " |";
    for (const auto& column : columns) {
      const auto range = std::find_if(ranges.begin(), ranges.end(), [&](const SafeRange& each) {
        return std::pair(each.level, each.analysis) == column && each.axis == axis.name;
      });
      if (range == ranges.end()) {
        text += " |";
      } else if (range->low > range->high) {
        text += " none |";
      } else {
        text += " " + number(range->low) + " … " + number(range->high) + " |";
      }
    }
    text += '\n';
  }
  return text;
}

std::string rows_csv(std::span<const StabilityRow> rows) {
  std::string text =
      "id,scene,level,analysis,axis,value,axis_2,value_2,verdict,reason,status,energy_balance_"
      "error,"
      "segment_steps,seconds\n";
  for (const StabilityRow& row : rows) {
    if (!row.begun) continue;
    text += report::csv_cell(row.id) + ',' + report::csv_cell(row.scene) + ',' +
            std::string(word_of(row.level)) + ',' +
            (row.analysis == Analysis::Dynamics ? "dynamics" : "statics");
    for (std::size_t i = 0; i < 2; ++i) {
      text +=
          i < row.at.size() ? ',' + row.at[i].axis + ',' + report::brief(row.at[i].value) : ",,";
    }
    text += ',' + std::string(kValidity[static_cast<std::size_t>(row.verdict.validity)]) + ',' +
            report::csv_cell(row.verdict.reason) + ',' + std::string(name_of(row.status)) + ',' +
            report::significant(row.energy_balance_error, 3) + ',' +
            report::significant(row.segment_steps, 6) + ',' + report::significant(row.seconds, 3) +
            '\n';
  }
  return text;
}

}  // namespace plastica::sweeps::stability
