#include "sweeps/stability/scene_scan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plastica/report/format.hpp"
#include "plastica/report/table.hpp"
#include "sweeps/stability/stability_map.hpp"

namespace plastica::sweeps::stability {
namespace {

std::string_view word_of_class(const Verdict& verdict) {
  return kValidity[static_cast<std::size_t>(verdict.validity)];
}

std::string own_text(const SceneScan& scan) {
  std::string text = "  own values  " + own_verdict_text(scan) + '\n';
  for (const std::string& warning : scan.warnings) {
    text += report::wrapped("  warning     ", report::printable(warning), 100);
  }
  return text;
}

void add_field(const ScannedField& one, const SceneScanOptions& options, report::Table& table) {
  const std::string_view unit = si_unit(one.field->dimension);
  const auto text = [](double value) { return report::brief(value); };
  table.add({std::string(one.field->path), unit == "1" ? "" : std::string(unit),
             text(one.below.value), text(one.value), text(one.above.value)});
  table.add_note("below: " + end_text(one.below, options));
  table.add_note("above: " + end_text(one.above, options));
}

}  // namespace

std::string end_text(const ScanLimit& limit, const SceneScanOptions& options) {
  switch (limit.end) {
    case ScanEnd::Verdict:
      return fmt::format("at {} {}: {}", report::brief(limit.next), word_of_class(limit.verdict),
                         limit.verdict.reason);
    case ScanEnd::Range: return "up to the end of what is allowed";
    case ScanEnd::Reach: return fmt::format("as far as it was followed, by {:g}", options.reach);
    case ScanEnd::Work:
      return fmt::format("then a run would take more than {:g} times the work", options.max_work);
    case ScanEnd::Samples: return "longer steps are cut to the samples";
    case ScanEnd::Whole: break;
  }
  return "there is no whole number within what it was followed by";
}

std::string own_verdict_text(const SceneScan& scan) {
  std::string text(word_of_class(scan.own));
  if (!scan.own.reason.empty()) {
    text += ": " + scan.own.reason;
  } else if (scan.deviation) {
    text += fmt::format(": {:.3g} % off a finer run", 100.0 * *scan.deviation);
    if (!scan.quantity.empty()) text += " (" + scan.quantity + ")";
  }
  return text;
}

std::string scene_scan_text(const SceneScan& scan, const SceneScanOptions& options) {
  std::string text = report::printable(scan.scene) +
                     ": how far each number may go, the others as they are\n" + own_text(scan);
  if (scan.fields.empty()) {
    if (scan.own.validity == Validity::Inaccurate) {
      text += "  nothing was varied: plastica advise says how fine the scene must be\n";
    }
    return text;
  }
  using Align = report::Table::Align;
  report::Table table({{"field", Align::Left}, {"", Align::Left}, {"from"}, {"value"}, {"to"}});
  std::string without_effect;
  for (const ScannedField& one : scan.fields) {
    if (one.matters()) {
      add_field(one, options, table);
    } else {
      without_effect += (without_effect.empty() ? "" : ", ") + std::string(one.field->path);
    }
  }
  text += "\n" + table.text(2, 120);
  if (!without_effect.empty()) {
    text += "\n" + report::wrapped("  change no probe: ", without_effect, 100);
  }
  const auto undetected = std::count_if(
      scan.rows.begin(), scan.rows.end(),
      [](const StabilityRow& row) { return row.verdict.validity == Validity::Undetected; });
  text += fmt::format("\n{} run, {} undetected {}\n", report::counted(scan.rows.size(), "point"),
                      undetected, undetected == 1 ? "error" : "errors");
  return text;
}

report::PlotScript pair_map(std::span<const StabilityRow> rows, const Setup& setup,
                            const Field& first, const Field& second, const report::Sheet& sheet) {
  const auto label = [](const ScannedValue& one) {
    const std::string sign = one.value < 0.0 ? "-" : "";
    return sign + one.axis + (one.unit == "1" ? "" : " [" + one.unit + "]");
  };
  std::array<std::array<double, 2>, 2> ranges{};
  // What is negative is so for all points: a factor changes no sign.
  const auto place = [&](std::size_t axis, double value) {
    const double size = std::fabs(value);
    auto& [low, high] = ranges[axis];
    low = low > 0.0 ? std::min(low, size) : size;
    high = std::max(high, size);
    return size;
  };
  std::array<std::vector<std::vector<double>>, 4> points;
  for (const StabilityRow& row : rows) {
    points[static_cast<std::size_t>(row.verdict.validity)].push_back(
        {place(0, row.at[0].value), place(1, row.at[1].value)});
  }
  const auto own = [&](std::size_t axis, const Field& field) {
    return place(axis, std::get<double>(field.get(setup)));
  };
  const std::vector<double> at_own{own(0, first), own(1, second)};
  report::PlotScript script(sheet);
  script.begin_panels(1);
  script.set_x_label(label(rows.front().at[0]));
  script.set_y_label(label(rows.front().at[1]));
  for (const std::size_t axis : {0U, 1U}) {
    const char letter = axis == 0 ? 'x' : 'y';
    const auto [low, high] = ranges[axis];
    const double room = std::max(1.2, std::pow(high / low, 0.06));
    script.command(fmt::format("set logscale {0}\nset {0}range [{1:.9g}:{2:.9g}]", letter,
                               low / room, high * room));
  }
  script.begin_panel({"each point a run"});
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].empty()) continue;
    script.add_series(
        script.add_points(points[k]),
        fmt::format("using 1:2 with points pointtype {} pointsize 1.2 linecolor rgb "
                    "'{}'",
                    class_symbol(static_cast<Validity>(k)), class_colour(static_cast<Validity>(k))),
        k == 3 ? "undetected error" : kValidity[k]);
  }
  script.add_series(script.add_points({at_own}),
                    fmt::format("using 1:2 with points pointtype 6 pointsize 3 linewidth 2 "
                                "linecolor rgb '{}'",
                                report::kDark),
                    "the scene's own");
  script.end_panel();
  return script;
}

}  // namespace plastica::sweeps::stability
