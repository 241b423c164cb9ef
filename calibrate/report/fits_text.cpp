#include "calibrate/report/fits_text.hpp"

#include <span>

#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/scene_fit_text.hpp"

namespace plastica::calibrate {
namespace {

/// The comparison of laws, if there is one. @param advised  becomes the records of the advised law
template <typename Record>
std::string laws_text(std::vector<Record>& records, const ReportOptions& options,
                      std::span<Record>& advised) {
  std::string text = laws_report(records, options);
  if (compares_laws(records)) text += "\n";
  advised = std::span(records).first(advised_first(records));
  return text;
}

}  // namespace

std::string fits_text(std::vector<FitRecord>& records, ReportOptions options, bool all) {
  if (all) options.specimens_shown = options.groups_shown = 0;
  std::span<FitRecord> advised;
  std::string text = laws_text(records, options, advised);
  if (all || advised.size() == 1) {
    for (const FitRecord& record : all ? std::span(records) : advised) {
      text += fit_report(record, options) + "\n";
    }
  }
  return text + batch_report(advised, options);
}

std::string fits_text(std::vector<SceneFitRecord>& records, ReportOptions options, bool all) {
  if (all) options.specimens_shown = 0;
  std::string text;
  if (all && records.size() > 1) {
    for (const SceneFitRecord& record : records) text += scene_fit_report(record, options) + "\n";
  }
  std::span<SceneFitRecord> advised;
  text += laws_text(records, options, advised);
  return text + scene_fits_report(advised, options);
}

}  // namespace plastica::calibrate
