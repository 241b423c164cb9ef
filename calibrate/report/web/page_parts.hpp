#pragma once

#include <fmt/format.h>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "calibrate/report/fit_flags.hpp"
#include "calibrate/report/format.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "calibrate/result/usable.hpp"
#include "plastica/report/web/web_blocks.hpp"
#include "plastica/report/web/web_page.hpp"

/// What the pages of both kinds of fits have; not installed.
namespace plastica::calibrate::report {

using plastica::report::WebTab;

/// "identified", or what is not: "no usable fit: …", "break_strain weak".
inline std::string verdict_of(const FitOutcome& fit, const std::string& why_unusable) {
  if (!fit.is_fitted()) return std::string(word_of(fit.status));
  if (!why_unusable.empty()) return "no usable fit";
  std::string words;
  for (const FittedParameter* p : fit.free_parameters()) {
    if (p->verdict() == Verdict::Identified) continue;
    words += (words.empty() ? "" : ", ") + p->name() + " " + std::string(word_of(p->verdict()));
  }
  return words.empty() ? "identified" : words;
}

/// A box of warnings, where there are any.
inline void add_warnings(WebTab& tab, const std::vector<std::string>& warnings) {
  if (!warnings.empty())
    tab.blocks.push_back(plastica::report::web_notes("Warnings", warnings, "warning"));
}

/// A block that may be null.
inline void add_block(WebTab& tab, Json block) {
  if (!block.is_null()) tab.blocks.push_back(std::move(block));
}

/// What the flags of a record are of.
inline const FitRecord& flagged(const FitRecord& record) { return record; }
inline const SceneFitResult& flagged(const SceneFitRecord& record) { return record.result; }

template <typename Record>
std::vector<const FitOutcome*> outcomes_of(const std::vector<Record>& records) {
  std::vector<const FitOutcome*> fits;
  fits.reserve(records.size());
  for (const Record& record : records) fits.push_back(&record.result);
  return fits;
}

/// "fitted 5 (1 of no use), rejected 1, failed 0; 2 with warnings", as the report ends.
/// @param records  of one law
template <typename Record>
std::string counts_line(std::span<const Record> records) {
  std::array<std::size_t, 3> counts{};
  std::size_t unusable = 0;
  std::size_t warned = 0;
  for (const Record& record : records) {
    ++counts[static_cast<std::size_t>(record.result.status)];
    if (record.result.is_fitted() && !is_usable(record.result)) ++unusable;
    if (flags_of(flagged(record)).find('w') != std::string::npos) ++warned;
  }
  const auto count = [&](FitStatus status) { return counts[static_cast<std::size_t>(status)]; };
  std::string line =
      fmt::format("fitted {}{}, rejected {}, failed {}", count(FitStatus::Fitted),
                  unusable_text(unusable), count(FitStatus::Rejected), count(FitStatus::Failed));
  if (warned > 0) line += fmt::format("; {} with warnings", warned);
  return line;
}

template <typename Record>
WebTab laws_tab(const std::vector<Record>& records, const ReportOptions& options) {
  WebTab tab{"Laws", Json::array()};
  tab.blocks.push_back(
      plastica::report::web_text("Laws beside each other", laws_report(records, options)));
  return tab;
}

}  // namespace plastica::calibrate::report
