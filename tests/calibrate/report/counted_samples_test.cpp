#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/law_choice.hpp"
#include "calibrate/report/plot.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/store/fit_store.hpp"
#include "tests/calibrate/store/synthetic_fits.hpp"
#include "tests/lib/io/scratch_folder.hpp"

namespace plastica::calibrate {
namespace {

/// All that commands write of a file's fits without their curves.
std::string reports_of(std::vector<FitRecord> records) {
  std::string text = laws_report(records) + batch_report(records) + json_summary(records);
  for (const FitRecord& record : records) text += fit_report(record);
  std::ostringstream table;
  write_fits_csv(table, records);
  advised_first(records);
  return text + table.str() + batch_report(records);
}

std::vector<FitRecord> fitted(const FitOptions& options) {
  std::vector<Target> targets = ideal_targets(5);
  // So many that a report says so.
  targets[1].repairs = {{"outliers", targets[1].raw.size() / 3, "lone samples dropped"}};
  const std::vector<FitCase> cases = cases_of(targets.size(), options);
  std::vector<FitResult> results = fit(targets, options);
  std::vector<FitRecord> records;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    records.push_back({targets[cases[i].target], std::move(results[i])});
  }
  return records;
}

/// Nothing that a report says may depend on samples that were only counted.
TEST(CountedSamples, AreEnoughForEveryReport) {
  FitOptions laws = ideal_options();
  laws.laws = {Law::Ideal, Law::Linear};
  FitOptions no_trace = ideal_options();
  no_trace.keep_trace = false;
  for (const FitOptions& options : {ideal_options(), no_trace, laws}) {
    const io::ScratchFolder folder;
    FitStoreContents contents;
    contents.options = options;
    contents.records = fitted(options);
    if (options.laws.empty()) contents.records.push_back(filled_record("odd"));
    write_fit_store(folder.file("a.h5"), contents);
    const std::string whole = reports_of(read_fit_store(folder.file("a.h5")).records);
    EXPECT_NE(whole.find("of the samples were dropped"), std::string::npos);
    const auto counted = read_fit_store(folder.file("a.h5"), FitSamples::Counted).records;
    EXPECT_EQ(reports_of(counted), whole);
    if (!options.laws.empty()) continue;  // whose comparison has read them
    std::ostringstream curves;
    EXPECT_THROW(write_curves_csv(curves, counted), std::logic_error);
    EXPECT_THROW((void)plot_script(counted, {}), std::logic_error);
  }
}

}  // namespace
}  // namespace plastica::calibrate
