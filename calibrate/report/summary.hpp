#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "calibrate/inference/mean_interval.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/base/quantity.hpp"

namespace plastica::calibrate {

/// Mean and scatter of a set of numbers.
struct Statistic {
  std::size_t n = 0;
  double mean = 0.0;                         ///< 0 if n = 0
  std::optional<double> standard_deviation;  ///< of the sample (n - 1); empty for n < 2
};

/// Statistic of the finite ones among numbers. They are summed in order of size, so that their
/// order does not change a bit of the result.
Statistic statistic_of(std::vector<double> values);

/// One of the characteristics that reports, JSON and files name.
struct CharacteristicEntry {
  std::string_view name;   ///< "youngs_modulus": in JSON, CSV and HDF5
  std::string_view label;  ///< "E": in reports
  Dimension dimension;
  std::optional<double> Characteristics::*value;
};

/// What there is to be shown of it.
std::optional<double> shown(const CharacteristicEntry& entry, const Characteristics& all);

/// All of them, in the order in which they are shown.
std::span<const CharacteristicEntry> characteristic_entries();

/// A specimen whose value is out of line with those of its group (`modified_z_scores`).
struct OutOfLine {
  std::size_t record = 0;  ///< its number among all records
  double value = 0.0;      ///< [SI], as the median
  double median = 0.0;     ///< of the group
  double score = 0.0;      ///< [1], its size above `kOutOfLine`
};

/// Differences from the median of less than this part of it are no scatter of specimens: reports
/// do not show them [1].
inline constexpr double kLeastDifference = 1e-5;

/// One quantity over the specimens of a group.
struct GroupStatistic {
  std::string name;  ///< of the characteristic or parameter
  Dimension dimension = Dimension::None;
  Statistic statistic;
  std::optional<MeanInterval> mean_interval;  ///< empty for n < 2
  /// In the order of the records. Those are not among them whose difference from the median is at
  /// most half the interval between samples that a break lies in, or below `kLeastDifference`.
  std::vector<OutOfLine> out_of_line{};
};

/// What the specimens of one group have in common.
struct GroupSummary {
  std::vector<std::pair<std::string, std::string>> group;  ///< as in Target; empty: no groups
  std::size_t fitted = 0;
  std::size_t rejected = 0;
  std::size_t failed = 0;
  /// Over the specimens that have it and whose target is neither rejected nor implausible; n >= 1.
  std::vector<GroupStatistic> characteristics;
  /// Free and tied parameters over the usable fits whose curve determines them; n >= 1 each.
  std::vector<GroupStatistic> parameters;
  std::size_t specimens() const { return fitted + rejected + failed; }
};

/// How many fits ended how.
struct Counts {
  std::size_t fitted = 0;
  std::size_t rejected = 0;
  std::size_t failed = 0;
  std::size_t unusable = 0;  ///< of the fitted ones (usable.hpp)
};

Counts count_statuses(std::span<const FitRecord> records);

/// "temperature 20, lot A"; "all specimens" for a group without keys.
std::string group_label(const std::vector<std::pair<std::string, std::string>>& group);

/// Whether a specimen's curve counts in what is said of its group: a rejected one does not, nor one
/// whose numbers no specimen has.
bool counts_in_group(const FitRecord& record);

/// Indices of the records of each group; groups in order of their values, numbers by size. Records
/// of several tests or measures are in groups of these.
std::vector<std::vector<std::size_t>> group_indices(std::span<const FitRecord> records);

/// The summary of each group, in the order of `group_indices`.
/// @param draws  how intervals of means are found, and their confidence
std::vector<GroupSummary> summarize_groups(std::span<const FitRecord> records,
                                           const SpecimenDraws& draws = {});

}  // namespace plastica::calibrate
