#include "cli/fit_reports.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "calibrate/report/fits_text.hpp"
#include "calibrate/report/json.hpp"
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
  fmt::print("{}", calibrate::fits_text(contents.records, options_of(contents), all));
}

void print_fits(calibrate::SceneFitContents& contents, bool all) {
  fmt::print("{}", calibrate::fits_text(contents.records, options_of(contents.confidence), all));
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
