#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "calibrate/report/interval_figures.hpp"
#include "calibrate/report/laws_figure.hpp"
#include "calibrate/report/plot.hpp"
#include "calibrate/report/quantile_figure.hpp"
#include "plastica/base/check.hpp"
#include "plastica/report/scene_figure.hpp"

/// Lists of the pictures of results of fits; not installed.
namespace plastica::calibrate::report {

using plastica::report::drawn;
using plastica::report::PlotScript;
using plastica::report::Sheet;

/// A kind of picture of a file of fits. One of the functions is set; what it draws is for a page,
/// or for a terminal as characters.
template <typename Record>
struct PictureKind {
  std::string_view name;  ///< "curve"
  std::string_view doc;   ///< one line for `--list`
  PlotScript (*of_one)(const Record& record, const Sheet& sheet) = nullptr;
  PlotScript (*of_all)(std::span<const Record> records, const Sheet& sheet) = nullptr;
  /// Of all laws that are compared; empty name: the first target's.
  PlotScript (*of_laws)(std::span<const Record> records, const std::string& name,
                        const Sheet& sheet) = nullptr;
};

/// @throws InputError naming all kinds
template <typename Record, std::size_t N>
const PictureKind<Record>& find_picture(const std::array<PictureKind<Record>, N>& kinds,
                                        const std::string& what) {
  const auto found = std::ranges::find(kinds, what, &PictureKind<Record>::name);
  if (found != kinds.end()) return *found;
  std::string names;
  for (std::size_t i = 0; i < N; ++i) {
    names += i == 0 ? "" : i + 1 < N ? ", " : " or ";
    names += kinds[i].name;
  }
  throw InputError({}, "--what", what, "must be " + names);
}

/// Their names and lines, for `--list`.
template <typename Record, std::size_t N>
constexpr std::array<PlotKind, N> listed(const std::array<PictureKind<Record>, N>& kinds) {
  std::array<PlotKind, N> list{};
  for (std::size_t i = 0; i < N; ++i) list[i] = {kinds[i].name, kinds[i].doc};
  return list;
}

/// Residuals of one fit against those of a normal distribution.
template <typename Record>
PlotScript quantiles_picture(const Record& record, const Sheet& sheet) {
  return drawn(quantiles_figure(record), sheet);
}

/// Likelihood intervals of one fit.
template <typename Record>
PlotScript profile_picture(const Record& record, const Sheet& sheet) {
  return drawn(profile_figure(shown_intervals(record.result, name_of(record))), sheet);
}

/// Resampled values of one fit.
template <typename Record>
PlotScript bootstrap_picture(const Record& record, const Sheet& sheet) {
  return drawn(bootstrap_figure(shown_intervals(record.result, name_of(record))), sheet);
}

/// What the laws that are compared make of one target, or fit.
template <typename Record>
PlotScript laws_picture(std::span<const Record> records, const std::string& name,
                        const Sheet& sheet) {
  return drawn(laws_figure(records, name), sheet);
}

}  // namespace plastica::calibrate::report
