#include "tests/fuzz/result_reading.hpp"

#include <sstream>
#include <string>

#include "calibrate/report/csv_export.hpp"
#include "calibrate/report/json.hpp"
#include "calibrate/report/scene_fit_text.hpp"
#include "calibrate/report/text.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "plastica/io/result_difference.hpp"
#include "plastica/io/scene_store.hpp"
#include "plastica/report/scene_csv.hpp"
#include "plastica/report/scene_json.hpp"
#include "plastica/report/scene_text.hpp"
#include "sweeps/report/csv.hpp"
#include "sweeps/report/json.hpp"
#include "sweeps/report/text.hpp"
#include "sweeps/store/sweep_store.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {
namespace {

void report(const calibrate::FitStoreContents& contents, bool has_curves = true) {
  std::ostringstream out;
  calibrate::batch_report(contents.records);
  for (const calibrate::FitRecord& record : contents.records) calibrate::fit_report(record);
  calibrate::write_fits_csv(out, contents.records);
  if (has_curves) calibrate::write_curves_csv(out, contents.records);
  calibrate::json_summary(contents.records);
}

void report(const calibrate::SceneFitContents& contents) {
  std::ostringstream out;
  calibrate::scene_fits_report(contents.records);
  for (const auto& record : contents.records) calibrate::scene_fit_report(record);
  calibrate::write_fits_csv(out, contents.records);
  calibrate::write_targets_csv(out, contents.records);
  calibrate::write_curves_csv(out, contents.records);
  calibrate::json_summary(contents.records);
}

void report(const io::SceneRecord& record) {
  std::ostringstream out;
  plastica::report::scene_report(record);
  plastica::report::scene_json(record);
  plastica::report::write_probes_csv(out, record);
  plastica::report::write_energies_csv(out, record);
  plastica::report::write_events_csv(out, record);
  plastica::report::write_fragments_csv(out, record);
}

void report(const sweeps::SweepRecord& record) {
  std::ostringstream out;
  sweeps::sweep_report(record);
  for (std::size_t i = 0; i < record.cases() && i < 4; ++i) sweeps::case_report(record, i);
  sweeps::sweep_json(record);
  sweeps::write_cases_csv(out, record);
  sweeps::write_sweep_curves_csv(out, record);
}

/// Whatever was read can be written, and is read again as the same.
template <typename Read, typename Write>
void read_and_write(const std::string& path, bool again, const Read& read, const Write& write) {
  const auto contents = result_or_refused([&] { return read(path); });
  if (!contents) return;
  read_or_refused([&] { report(*contents); });
  if (!again) return;
  const std::string first = scratch_path("first.h5");
  const std::string second = scratch_path("second.h5");
  write(first, *contents);
  write(second, read(first));
  require(content_of(first) == content_of(second), "a result that reads as another one");
}

}  // namespace

void read_result(const std::string& path, bool again) {
  const auto schema = result_or_refused([&] { return io::schema_of(path); });
  if (!schema) return;
  if (*schema == calibrate::kFitStoreSchema) {
    read_and_write(
        path, again, [](const auto& from) { return calibrate::read_fit_store(from); },
        [](const auto& to, const auto& contents) { calibrate::write_fit_store(to, contents); });
    const auto counted = result_or_refused(
        [&] { return calibrate::read_fit_store(path, calibrate::FitSamples::Counted); });
    if (counted) read_or_refused([&] { report(*counted, false); });
  } else if (*schema == calibrate::kSceneFitSchema) {
    read_and_write(path, again, calibrate::read_scene_fit_store,
                   [](const auto& to, const auto& contents) {
                     calibrate::write_scene_fit_store(to, contents);
                   });
  } else if (*schema == io::kSceneSchema) {
    read_and_write(path, again, io::read_scene_store,
                   [](const auto& to, const auto& record) { io::write_scene_store(to, record); });
  } else if (*schema == sweeps::kSweepSchema) {
    read_and_write(path, again, sweeps::read_sweep_store, [](const auto& to, const auto& record) {
      sweeps::write_sweep_store(to, record);
    });
    if (again) read_or_refused([&] { return sweeps::earlier_results(path); });
  }
  if (again) read_or_refused([&] { return io::compare_results(path, path, {}); });
}

}  // namespace plastica::fuzz
