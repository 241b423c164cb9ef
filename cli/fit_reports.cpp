#include "cli/fit_reports.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <span>
#include <vector>

#include "calibrate/report/json.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/text.hpp"
#include "cli/find_record.hpp"
#include "cli/launched.hpp"
#include "cli/terminal.hpp"

namespace plastica::cli {
namespace {

calibrate::ReportOptions options_of(double confidence) {
  calibrate::ReportOptions options;
  // mpirun makes a terminal for what it passes on, wherever that goes.
  options.color = has_color(STDOUT_FILENO) && !launched();
  options.confidence = confidence;
  return options;
}

calibrate::ReportOptions options_of(const calibrate::FitStoreContents& contents) {
  calibrate::ReportOptions options = options_of(contents.options.confidence);
  options.specimen_resamples = contents.options.intervals.specimens;
  options.seed = contents.options.seed;
  return options;
}

/// Prints the comparison of laws, if there is one. @return the records of the advised law
template <typename Record>
std::span<Record> print_laws(std::vector<Record>& records,
                             const calibrate::ReportOptions& options) {
  fmt::print("{}", calibrate::laws_report(records, options));
  if (calibrate::compares_laws(records)) fmt::print("\n");
  return std::span(records).first(calibrate::advised_first(records));
}

}  // namespace

std::string json_of(const calibrate::FitStoreContents& contents) {
  const calibrate::FitOptions& fit = contents.options;
  return calibrate::json_summary(contents.records, 2,
                                 {fit.intervals.specimens, fit.seed, fit.confidence});
}
std::string json_of(const calibrate::SceneFitContents& contents) {
  return calibrate::json_summary(contents.records, contents.confidence);
}

void print_fits(calibrate::FitStoreContents& contents, bool all) {
  calibrate::ReportOptions options = options_of(contents);
  if (all) options.specimens_shown = options.groups_shown = 0;
  const auto advised = print_laws(contents.records, options);
  if (all || advised.size() == 1) {
    for (const auto& record : all ? std::span(contents.records) : advised) {
      fmt::print("{}\n", calibrate::fit_report(record, options));
    }
  }
  fmt::print("{}", calibrate::batch_report(advised, options));
}

void print_fits(calibrate::SceneFitContents& contents, bool all) {
  calibrate::ReportOptions options = options_of(contents.confidence);
  if (all) options.specimens_shown = 0;
  if (all && contents.records.size() > 1) {
    for (const auto& record : contents.records) {
      fmt::print("{}\n", calibrate::scene_fit_report(record, options));
    }
  }
  const auto advised = print_laws(contents.records, options);
  fmt::print("{}", calibrate::scene_fits_report(advised, options));
}

void print_fit(const calibrate::FitStoreContents& contents, const std::string& name,
               const std::string& file) {
  const auto& record = find_record(contents.records, name, file);
  fmt::print("{}", calibrate::fit_report(record, options_of(contents)));
}
void print_fit(const calibrate::SceneFitContents& contents, const std::string& name,
               const std::string& file) {
  const auto& record = find_record(contents.records, name, file);
  fmt::print("{}", calibrate::scene_fit_report(record, options_of(contents.confidence)));
}

}  // namespace plastica::cli
