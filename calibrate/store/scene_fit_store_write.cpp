#include "calibrate/store/scene_fit_store.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

constexpr io::DatasetOptions kPlain{{}, store::kDeflate};

[[noreturn]] void refuse(const SceneFitRecord& record, const std::string& why) {
  throw std::logic_error("write_scene_fit_store: " + record.name + " " + why);
}

void check(const SceneFitRecord& record) {
  const std::vector<TargetFit>& made = record.result.targets;
  if (record.weights.size() != record.targets.size())
    refuse(record, "does not have a weight for each target");
  if (!made.empty() && made.size() != record.targets.size()) {
    refuse(record, "does not have a fit for each target");
  }
  for (std::size_t p = 0; p < record.targets.size(); ++p) {
    const SceneTarget& target = record.targets[p];
    if (target.ordinate.size() != target.abscissa.size()) {
      refuse(record, "has a curve with more abscissas than ordinates or fewer");
    }
    if (made.empty()) continue;
    if (made[p].name != target.name) refuse(record, "has a fit of another name than its target");
    if (!made[p].fitted.empty() && made[p].fitted.size() != target.abscissa.size()) {
      refuse(record, "does not have a fitted ordinate for each abscissa");
    }
    if (made[p].fitted_error.size() != made[p].fitted.size()) {
      refuse(record, "does not have an error for each fitted ordinate");
    }
  }
}

/// Pointers to the records, sorted by name and law and checked.
std::vector<const SceneFitRecord*> by_name(const std::vector<SceneFitRecord>& records) {
  std::vector<const SceneFitRecord*> sorted = store::pointers_to(std::span(records));
  const auto name = [](const SceneFitRecord* record) {
    return std::pair<std::string_view, Law>(record->name, record->result.law);
  };
  std::ranges::sort(sorted, std::less<>(), name);
  const auto twice = std::ranges::adjacent_find(sorted, std::equal_to<>(), name);
  if (twice != sorted.end()) refuse(**twice, "is the name of two fits");
  for (const SceneFitRecord* record : sorted) check(*record);
  return sorted;
}

using Records = std::vector<const SceneFitRecord*>;

/// A column of units beside columns whose unit differs from row to row, for other readers.
template <typename Rows, typename DimensionOf>
void write_units(io::Hdf5Group& group, std::string_view name, const Rows& rows,
                 const DimensionOf& dimension_of) {
  std::vector<std::string> units(rows.size());
  std::ranges::transform(rows, units.begin(),
                         [&](const auto* row) { return std::string(si_unit(dimension_of(*row))); });
  group.write_texts(name, units);
}

/// What the fits made of their targets, as these stand in `targets`; null where one has nothing.
std::vector<const TargetFit*> made_of(const Records& records) {
  std::vector<const TargetFit*> made;
  for (const SceneFitRecord* record : records) {
    for (std::size_t p = 0; p < record->targets.size(); ++p) {
      made.push_back(record->result.targets.empty() ? nullptr : &record->result.targets[p]);
    }
  }
  return made;
}

void write_curves(io::Hdf5Group& root, const std::vector<const SceneTarget*>& targets,
                  const std::vector<const TargetFit*>& made) {
  std::vector<double> abscissa, ordinate, fitted, error;
  std::vector<std::uint64_t> offsets{0};
  for (std::size_t p = 0; p < targets.size(); ++p) {
    const SceneTarget& target = *targets[p];
    abscissa.insert(abscissa.end(), target.abscissa.begin(), target.abscissa.end());
    ordinate.insert(ordinate.end(), target.ordinate.begin(), target.ordinate.end());
    if (made[p] != nullptr) {
      fitted.insert(fitted.end(), made[p]->fitted.begin(), made[p]->fitted.end());
      error.insert(error.end(), made[p]->fitted_error.begin(), made[p]->fitted_error.end());
    }
    for (std::vector<double>* column : {&fitted, &error}) {
      column->resize(abscissa.size(), std::numeric_limits<double>::quiet_NaN());
    }
    offsets.push_back(abscissa.size());
  }
  io::Hdf5Group group = root.group("curves");
  group.write("abscissa", abscissa, kPlain);
  group.write("ordinate", ordinate, kPlain);
  group.write("fitted", fitted, kPlain);
  group.write("fitted_error", error, kPlain);
  group.write("offsets", offsets, kPlain);
}

void write_targets(io::Hdf5Group& root, const Records& records) {
  const auto targets = store::items_of(records, PLASTICA_MEMBER(targets));
  io::Hdf5Group group = store::write_items(root, "targets", targets, kDescribeSceneTarget);
  write_units(group, "abscissa_units", targets.rows, PLASTICA_MEMBER(abscissa_is));
  write_units(group, "ordinate_units", targets.rows, PLASTICA_MEMBER(ordinate_is));
  const std::vector<const TargetFit*> made = made_of(records);
  std::vector<std::uint8_t> present, has_curve;
  std::vector<double> weights;
  for (const TargetFit* each : made) {
    present.push_back(each != nullptr ? 1 : 0);
    has_curve.push_back(each != nullptr && !each->fitted.empty() ? 1 : 0);
  }
  for (const SceneFitRecord* record : records) {
    weights.insert(weights.end(), record->weights.begin(), record->weights.end());
  }
  group.write("weight", weights, {"1", store::kDeflate});
  group.write("has_curve", has_curve, kPlain);
  group.write("present", present, kPlain);
  store::write_columns(group, made, kDescribeTargetFit);
  write_curves(root, targets.rows, made);
  store::write_items(root, "repairs", store::items_of(targets.rows, PLASTICA_MEMBER(repairs)),
                     kDescribeRepair, "target");
}

void write_lists(io::Hdf5Group& root, const Records& records) {
  std::vector<const FitOutcome*> fits;
  for (const SceneFitRecord* record : records) fits.push_back(&record->result);
  store::write_parameters(root, fits, store::parameters_of(fits));
  const auto segments = store::items_of(
      records, [](const SceneFitRecord& r) -> const auto& {
        static const std::vector<SegmentsError> kNone;
        return r.result.segments ? r.result.segments->parameters : kNone;
      });
  store::write_items(root, "segments", segments, kDescribeSegments);
  const auto starts = store::items_of(records, PLASTICA_MEMBER(result.starts));
  io::Hdf5Group of_starts = store::write_items(root, "starts", starts, kDescribeStart);
  io::Ragged<double> from, to;
  for (const SceneStart* start : starts.rows) {
    from.push_back(start->from);
    to.push_back(start->to);
  }
  of_starts.write_ragged("from", from, kPlain);
  of_starts.write_ragged("to", to, kPlain);
  const auto warnings = store::items_of(records, PLASTICA_MEMBER(result.warnings));
  store::write_items(root, "warnings", warnings, kDescribeText);
}

std::vector<store::StoredIntervals> intervals_of(
    const std::vector<const SceneFitRecord*>& records) {
  std::vector<store::StoredIntervals> all;
  for (const SceneFitRecord* record : records) {
    store::StoredIntervals& one = all.emplace_back();
    one.intervals = &record->result.intervals;
    for (const FittedParameter& p : record->result.parameters) one.paths.push_back(p.path);
  }
  return all;
}

}  // namespace

void write_scene_fit_store(const std::string& path, const SceneFitContents& contents,
                           io::Overwrite overwrite) {
  const std::vector<const SceneFitRecord*> records = by_name(contents.records);
  io::Hdf5File file = io::Hdf5File::create(path, overwrite);
  io::Hdf5Group& root = file.root();
  io::write_schema(root, kSceneFitSchema, kSceneFitVersion);
  io::write_run_id(root, contents.run);
  io::Hdf5Group fits = root.group("fits");
  store::write_columns(fits, records, kDescribeSceneFit);
  io::Ragged<double> correlation, held_out;
  for (const SceneFitRecord* record : records) {
    correlation.push_back(record->result.correlation);
    held_out.push_back(record->result.held_out);
  }
  root.write_ragged("correlation", correlation, {"1", store::kDeflate});
  root.write_ragged("held_out", held_out, {"1", store::kDeflate});
  write_targets(root, records);
  write_lists(root, records);
  store::write_intervals(root, intervals_of(records));
  root.write("options/confidence", contents.confidence, {"1"});
  io::write_inputs(root, contents.inputs);
  io::write_meta(root, contents.meta);
  std::vector<double> seconds;
  seconds.reserve(records.size());
  for (const SceneFitRecord* record : records) seconds.push_back(record->seconds);
  root.write("meta/fit_seconds", seconds, {"s"});
  file.commit();
}

}  // namespace plastica::calibrate
