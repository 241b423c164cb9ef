#include "calibrate/report/summary.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "calibrate/inference/out_of_line.hpp"
#include "calibrate/result/usable.hpp"
#include "calibrate/result/words.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::array<CharacteristicEntry, 8> kEntries = {{
    {"youngs_modulus", "E", Dimension::Stress, &Characteristics::youngs_modulus},
    {"proof_stress", "Rp", Dimension::Stress, &Characteristics::proof_stress},
    {"reh", "ReH", Dimension::Stress, &Characteristics::reh},
    {"rel", "ReL", Dimension::Stress, &Characteristics::rel},
    {"rm", "Rm", Dimension::Stress, &Characteristics::rm},
    {"strain_at_rm", "strain at Rm", Dimension::Strain, &Characteristics::strain_at_rm},
    {"break_strain", "break, total", Dimension::Strain, &Characteristics::break_strain},
    {"break_strain_plastic", "break, permanent", Dimension::Strain,
     &Characteristics::break_strain_plastic},
}};

using Group = std::vector<std::pair<std::string, std::string>>;

/// The whole text as a finite number.
std::optional<double> number_of(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Numbers come before words, numbers by size; a strict order.
bool value_before(const std::string& a, const std::string& b) {
  const std::optional<double> x = number_of(a);
  const std::optional<double> y = number_of(b);
  if (x.has_value() != y.has_value()) return x.has_value();
  if (x && *x != *y) return *x < *y;
  return a < b;
}

struct GroupBefore {
  bool operator()(const Group& a, const Group& b) const {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                        [](const auto& p, const auto& q) {
                                          if (p.first != q.first) return p.first < q.first;
                                          return value_before(p.second, q.second);
                                        });
  }
};

/// Numbers of the same name, in the order in which the names came up.
struct Collector {
  struct Entry {
    GroupStatistic result;
    std::vector<double> values;
    std::vector<double> halves;          ///< of the sampling intervals of breaks (n_values)
    std::vector<std::size_t> records{};  ///< whose they are (n_values)
  };
  std::vector<Entry> entries;

  /// @param half  half the interval between the samples that it lies between; 0: it is no break
  void add(std::size_t record, std::string_view name, Dimension dimension, double value,
           double half) {
    if (!std::isfinite(value)) return;
    auto entry = std::find_if(entries.begin(), entries.end(),
                              [&](const Entry& e) { return e.result.name == name; });
    if (entry == entries.end()) {
      entry = entries.insert(entries.end(), Entry{{std::string(name), dimension, {}, {}}, {}, {}});
    }
    entry->values.push_back(value);
    entry->halves.push_back(half);
    entry->records.push_back(record);
  }

  static std::vector<OutOfLine> out_of_line(const Entry& entry) {
    const ModifiedZScores found = modified_z_scores(entry.values);
    std::vector<OutOfLine> all;
    for (std::size_t k = 0; k < found.scores.size(); ++k) {
      const double off = std::fabs(entry.values[k] - found.median);
      const double least = std::max(entry.halves[k], kLeastDifference * std::fabs(found.median));
      if (std::fabs(found.scores[k]) <= kOutOfLine || off <= least) continue;
      all.push_back({entry.records[k], entry.values[k], found.median, found.scores[k]});
    }
    return all;
  }

  std::vector<GroupStatistic> statistics(const SpecimenDraws& draws) && {
    std::vector<GroupStatistic> all;
    for (Entry& entry : entries) {
      if (entry.values.size() > 1) {
        const auto n = static_cast<double>(entry.values.size());
        double squares = 0.0;
        for (const double half : entry.halves) squares += half * half;
        entry.result.mean_interval = mean_interval(entry.values, draws, std::sqrt(squares / n));
      }
      entry.result.out_of_line = out_of_line(entry);
      entry.result.statistic = statistic_of(std::move(entry.values));
      all.push_back(std::move(entry.result));
    }
    return all;
  }
};

double half_of(const CharacteristicEntry& entry, const Characteristics& all) {
  const bool is_break = entry.value == &Characteristics::break_strain ||
                        entry.value == &Characteristics::break_strain_plastic;
  return is_break && all.observed_break ? all.observed_break->half_interval() : 0.0;
}

/// The group of each record. Where records differ in test or measure, these part them too: the
/// modulus of a torsion test is no Young's modulus, and true stress is another one.
std::vector<Group> groups_of(std::span<const FitRecord> records) {
  bool tests = false;
  bool measures = false;
  for (const FitRecord& record : records) {
    tests = tests || record.target.test != records.front().target.test;
    measures = measures || record.target.measure != records.front().target.measure;
  }
  std::vector<Group> groups;
  groups.reserve(records.size());
  for (const FitRecord& record : records) {
    Group group = record.target.group;
    if (tests) group.emplace_back("test", word_of(record.target.test));
    if (measures) group.emplace_back("measure", word_of(record.target.measure));
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Whether a parameter is where its search had to end, which says how far it may go and not what it
/// is: not where it can be no larger, or smaller, at all.
bool is_at_given_bound(const FittedParameter& parameter) {
  const auto& range = find_field(parameter.path).range;
  return (parameter.at_lower && parameter.lower > range.low) ||
         (parameter.at_upper && parameter.upper < range.high);
}

GroupSummary summarize(std::span<const FitRecord> records, const std::vector<std::size_t>& members,
                       Group group, const SpecimenDraws& draws) {
  GroupSummary summary;
  summary.group = std::move(group);
  Collector characteristics;
  Collector parameters;
  for (const CharacteristicEntry& entry : kEntries) {
    for (const std::size_t i : members) {
      if (!counts_in_group(records[i])) continue;
      const std::optional<double> value = shown(entry, records[i].target.characteristics);
      if (!value) continue;
      characteristics.add(i, entry.name, entry.dimension, *value,
                          half_of(entry, records[i].target.characteristics));
    }
  }
  for (const std::size_t i : members) {
    const FitResult& result = records[i].result;
    if (result.status == FitStatus::Fitted) ++summary.fitted;
    if (result.status == FitStatus::Rejected) ++summary.rejected;
    if (result.status == FitStatus::Failed) ++summary.failed;
    if (!is_usable(result)) continue;
    for (const FittedParameter& parameter : result.parameters) {
      if (parameter.role == ParameterRole::Fixed || !parameter.identified) continue;
      if (is_at_given_bound(parameter)) continue;
      parameters.add(i, parameter.name(), parameter.dimension, parameter.value,
                     std::sqrt(3.0) * parameter.sampling_error);
    }
  }
  summary.characteristics = std::move(characteristics).statistics(draws);
  summary.parameters = std::move(parameters).statistics(draws);
  return summary;
}

}  // namespace

Statistic statistic_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::sort(values.begin(), values.end());
  Statistic statistic;
  statistic.n = values.size();
  if (values.empty()) return statistic;
  const auto n = static_cast<double>(values.size());
  double sum = 0.0;
  for (const double value : values) sum += value;
  statistic.mean = sum / n;
  if (values.size() < 2) return statistic;
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - statistic.mean) * (value - statistic.mean);
  }
  statistic.standard_deviation = std::sqrt(squares / (n - 1.0));
  return statistic;
}

std::optional<double> shown(const CharacteristicEntry& entry, const Characteristics& all) {
  return entry.value == &Characteristics::youngs_modulus ? all.sound_modulus() : all.*entry.value;
}

std::span<const CharacteristicEntry> characteristic_entries() { return kEntries; }

Counts count_statuses(std::span<const FitRecord> records) {
  Counts counts;
  for (const FitRecord& record : records) {
    if (record.result.status == FitStatus::Fitted) ++counts.fitted;
    if (record.result.status == FitStatus::Rejected) ++counts.rejected;
    if (record.result.status == FitStatus::Failed) ++counts.failed;
    if (!why_unusable(record.result).empty()) ++counts.unusable;
  }
  return counts;
}

std::string group_label(const Group& group) {
  if (group.empty()) return "all specimens";
  std::string label;
  for (const auto& [key, value] : group) {
    if (!label.empty()) label += ", ";
    label.append(key).append(" ").append(value);
  }
  return label;
}

bool counts_in_group(const FitRecord& record) {
  const TargetStatus status = record.target.status;
  return status != TargetStatus::Rejected && status != TargetStatus::Implausible;
}

std::vector<std::vector<std::size_t>> group_indices(std::span<const FitRecord> records) {
  std::map<Group, std::vector<std::size_t>, GroupBefore> groups;
  const std::vector<Group> of = groups_of(records);
  for (std::size_t i = 0; i < records.size(); ++i) groups[of[i]].push_back(i);
  std::vector<std::vector<std::size_t>> all;
  all.reserve(groups.size());
  for (auto& [group, members] : groups) all.push_back(std::move(members));
  return all;
}

std::vector<GroupSummary> summarize_groups(std::span<const FitRecord> records,
                                           const SpecimenDraws& draws) {
  std::vector<GroupSummary> all;
  const std::vector<Group> of = groups_of(records);
  for (const std::vector<std::size_t>& members : group_indices(records)) {
    all.push_back(summarize(records, members, of[members.front()], draws));
  }
  return all;
}

}  // namespace plastica::calibrate
