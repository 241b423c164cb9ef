#include "calibrate/report/text_groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calibrate/inference/out_of_line.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/summary.hpp"
#include "plastica/report/table.hpp"

namespace plastica::calibrate::report {
namespace {

using plastica::report::Ink;
using plastica::report::kWidth;
using plastica::report::Table;

std::string label_of(std::string_view name, const std::string& modulus, const std::string& proof) {
  if (name == "youngs_modulus") return modulus;
  if (name == "proof_stress") return proof;
  for (const CharacteristicEntry& entry : characteristic_entries()) {
    if (entry.name == name) return std::string(entry.label);
  }
  return printable(name);
}

/// "301.2 … 304.5"; empty without one.
std::string mean_interval_text(const GroupStatistic& entry, const DisplayUnit& unit) {
  if (!entry.mean_interval) return {};
  const double low = entry.mean_interval->low / unit.scale;
  const double high = entry.mean_interval->high / unit.scale;
  const double error = 0.25 * (high - low);
  if (!(error >= 1e-6) || std::max(std::fabs(low), std::fabs(high)) >= 1e7) {
    return significant(low) + " … " + significant(high);
  }
  const int decimals = decimals_for(entry.statistic.mean / unit.scale, error);
  return fmt::format("{:.{}f} … {:.{}f}", low, decimals, high, decimals);
}

void add_statistic(Table& table, const GroupStatistic& entry, const std::string& label) {
  const bool modulus = entry.name.find("modulus") != std::string::npos;
  const DisplayUnit unit = display_unit(entry.dimension, entry.statistic.mean, modulus);
  const Statistic& statistic = entry.statistic;
  const double mean = statistic.mean / unit.scale;
  std::string middle = significant(mean);
  std::string deviation = "-";
  if (statistic.standard_deviation) {
    const double scatter = *statistic.standard_deviation / unit.scale;
    deviation = significant(scatter, 3);
    if (std::fabs(mean) < 1e7 && std::fabs(mean) > 1e-4) {
      // With as many decimals as the scatter says something of.
      const int decimals = scatter > 0.0 ? decimals_for(mean, scatter, 3) : 3;
      middle = fmt::format("{:.{}f}", mean, decimals);
      deviation = fmt::format("{:.{}f}", scatter, decimals);
    }
  }
  std::vector<std::string> cells = {
      label,     std::to_string(statistic.n),     middle,
      deviation, mean_interval_text(entry, unit), std::string(unit.name)};
  table.add(std::move(cells));
}

/// A line for each specimen that is out of line with its group in a quantity.
std::string out_of_line_text(const GroupStatistic& entry, const std::string& label,
                             std::span<const FitRecord> records) {
  std::string text;
  for (const OutOfLine& one : entry.out_of_line) {
    const bool modulus = entry.name.find("modulus") != std::string::npos;
    const DisplayUnit unit = display_unit(entry.dimension, one.median, modulus);
    text += wrapped(
        "  out of line: ",
        fmt::format("{}, {} {}, median of the group {}, score {}",
                    printable(records[one.record].name()), label,
                    plastica::report::quantity(significant(one.value / unit.scale), unit.name),
                    significant(one.median / unit.scale), significant(one.score, 3)),
        kWidth);
  }
  return text;
}

}  // namespace

std::string proof_label(std::span<const FitRecord> records) {
  std::optional<double> offset;
  for (const FitRecord& record : records) {
    const std::optional<double>& here = record.target.characteristics.offset;
    if (here && offset && *here != *offset) return "Rp";
    if (here) offset = here;
  }
  return "Rp" + brief(100.0 * offset.value_or(0.002));
}

std::string modulus_label(std::span<const FitRecord> records) {
  const auto is_torsion = [](const FitRecord& record) {
    return record.target.test == Test::Torsion;
  };
  if (std::ranges::none_of(records, is_torsion)) return "E";
  return std::ranges::all_of(records, is_torsion) ? "G" : "E, G";
}

namespace {

/// The same of a group, which is of one test where tests part it from others.
std::string modulus_of(const GroupSummary& group, std::span<const FitRecord> records) {
  for (const auto& [key, value] : group.group) {
    if (key != "test") continue;
    if (value == "torsion") return "G";
    if (value == "tension" || value == "bending") return "E";
  }
  return modulus_label(records);
}

}  // namespace

std::string characteristic_label(std::string_view name, const GroupSummary& group,
                                 std::span<const FitRecord> records) {
  return label_of(name, modulus_of(group, records), proof_label(records));
}

std::string characteristic_label(std::string_view name, std::span<const FitRecord> records) {
  return label_of(name, modulus_label(records), proof_label(records));
}

std::string out_of_line_rule() {
  return fmt::format(
      "out of line: modified z-score beyond {} (Iglewicz and Hoaglin 1993), in groups of {} values "
      "and more",
      kOutOfLine, kFewestInLine);
}

std::string groups_text(std::span<const FitRecord> records, const ReportOptions& options,
                        const Ink& ink) {
  const SpecimenDraws draws{options.specimen_resamples, options.seed, options.confidence};
  const std::vector<GroupSummary> groups = summarize_groups(records, draws);
  const bool drawn = draws.resamples > 0 && std::ranges::any_of(groups, [](const auto& group) {
                       return group.fitted >= kFewestToDraw;
                     });
  const std::size_t shown =
      options.groups_shown == 0 ? groups.size() : std::min(groups.size(), options.groups_shown);
  std::string text;
  bool any_out_of_line = false;
  for (std::size_t g = 0; g < shown; ++g) {
    const GroupSummary& group = groups[g];
    text +=
        '\n' + ink.heading(wrapped("",
                                   fmt::format("Group {}: {}", printable(group_label(group.group)),
                                               counted(group.specimens(), "specimen")),
                                   kWidth));
    Table table(
        {{"", Table::Align::Left},
         {"n"},
         {"mean"},
         {"std. dev."},
         {fmt::format("{:.4g} % of the mean", 100.0 * options.confidence), Table::Align::Range},
         {"", Table::Align::Left}});
    std::string out_of_line;
    for (const GroupStatistic& entry : group.characteristics) {
      const std::string label = characteristic_label(entry.name, group, records);
      add_statistic(table, entry, label);
      out_of_line += out_of_line_text(entry, label, records);
    }
    if (!group.parameters.empty()) table.add_line("fitted");
    for (const GroupStatistic& entry : group.parameters) {
      add_statistic(table, entry, printable(entry.name));
      out_of_line += out_of_line_text(entry, printable(entry.name), records);
    }
    if (table.rows() > 0) text += table.text(2, kWidth);
    text += out_of_line;
    any_out_of_line = any_out_of_line || !out_of_line.empty();
  }
  if (any_out_of_line) text += wrapped("  ", out_of_line_rule(), kWidth);
  const bool any =
      std::ranges::any_of(groups, [](const GroupSummary& group) { return group.specimens() > 1; });
  const auto shares_sampling = [](const GroupStatistic& entry) {
    return entry.mean_interval && entry.mean_interval->sampling_error > 0.0;
  };
  const bool is_shared = std::ranges::any_of(groups, [&](const GroupSummary& group) {
    return std::ranges::any_of(group.characteristics, shares_sampling) ||
           std::ranges::any_of(group.parameters, shares_sampling);
  });
  if (any) {
    std::string how = "of the mean: Student's t";
    if (drawn) {
      how += fmt::format("; of {} values and more bootstrap-t of {}", kFewestToDraw,
                         counted(static_cast<std::size_t>(draws.resamples), "resample"));
    } else if (draws.resamples > 0) {
      how += fmt::format(": no group has the {} values that a bootstrap takes", kFewestToDraw);
    }
    text += wrapped("  ", how, kWidth);
    if (is_shared) {
      text += wrapped("  ",
                      "of breaks that lie between the same two samples also their place between "
                      "these, whatever the number of specimens",
                      kWidth);
    }
  }
  if (shown < groups.size()) {
    text += fmt::format("\n… {} left out …\n", counted(groups.size() - shown, "group"));
  }
  return text;
}

}  // namespace plastica::calibrate::report
