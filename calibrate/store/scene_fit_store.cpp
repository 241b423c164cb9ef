#include "calibrate/store/scene_fit_store.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/layout.hpp"
#include "calibrate/store/older_parameters.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

/// As a file has it. @throws std::logic_error if the record is not complete
store::StoredSceneFit stored(const SceneFitRecord& record) {
  const auto refuse = [&](const char* why) {
    throw std::logic_error("write_scene_fit_store: " + record.name + " " + why);
  };
  const std::vector<TargetFit>& made = record.result.targets;
  if (record.weights.size() != record.targets.size()) {
    refuse("does not have a weight for each target");
  }
  if (!made.empty() && made.size() != record.targets.size()) {
    refuse("does not have a fit for each target");
  }
  store::StoredSceneFit fit{record.name, {}, record.result, record.seconds};
  for (std::size_t t = 0; t < record.targets.size(); ++t) {
    store::StoredTarget& target = fit.targets.emplace_back();
    target.target = record.targets[t];
    target.weight = record.weights[t];
    if (made.empty()) continue;
    if (made[t].name != target.target.name) refuse("has a fit of another name than its target");
    target.made = made[t];
    target.has_curve = !made[t].fitted.empty();
    if (made[t].fitted_error.size() != made[t].fitted.size()) {
      refuse("does not have an error for each fitted ordinate");
    }
  }
  return fit;
}

SceneFitRecord record_of(store::StoredSceneFit&& fit, int version) {
  SceneFitRecord record{std::move(fit.name), {}, {}, std::move(fit.result), fit.seconds};
  for (store::StoredTarget& target : fit.targets) {
    record.weights.push_back(target.weight);
    if (target.made) {
      TargetFit& made = record.result.targets.emplace_back(std::move(*target.made));
      made.name = target.target.name;
      if (version < 7) made.law = record.result.law;
    }
    record.targets.push_back(std::move(target.target));
  }
  return record;
}

void check_what_was_read(const io::Hdf5Group& root, const SceneFitRecord& record) {
  const auto refuse = [&](const char* path, const char* rule) {
    io::refuse_value(root, path, "", rule);
  };
  const SceneFitResult& result = record.result;
  const std::size_t made = result.targets.size();
  if (record.targets.empty()) refuse("targets/fit", "must name each fit");
  if (result.is_fitted() && (made == 0 || result.parameters.empty())) {
    refuse("targets/present", "must hold for each fit that was made");
  }
  for (std::size_t t = 0; result.is_fitted() && t < std::min(made, record.targets.size()); ++t) {
    if (result.targets[t].fitted.size() == record.targets[t].ordinate.size()) continue;
    refuse("targets/has_curve", "must hold for each target of a fit that was made");
  }
  if (made != 0 && made != record.targets.size()) {
    refuse("targets/present", "must be the same for all targets of a fit");
  }
  if (result.segments && result.segments->parameters.size() != result.free_count()) {
    refuse("segments/fit", "must have a row for each parameter of a fit");
  }
  for (const SceneStart& start : result.starts) {
    if (!start.to.empty() && start.to.size() != start.from.size()) {
      refuse("starts/to", "must have a value for each parameter that is searched");
    }
  }
  const auto held_before_free = [](const FittedParameter& a, const FittedParameter& b) {
    return a.role != ParameterRole::Free && b.role == ParameterRole::Free;
  };
  if (std::ranges::adjacent_find(result.parameters, held_before_free) != result.parameters.end()) {
    refuse("parameters", "must have the free ones of a fit before the others");
  }
  store::check_outcome(root, result, result.free_count());
}

constexpr auto kSeconds = [](auto& columns) {
  columns("fit_seconds", "s", PLASTICA_MEMBER(seconds));
};

}  // namespace

void write_scene_fit_store(const std::string& path, const SceneFitContents& contents,
                           io::Overwrite overwrite) {
  std::vector<store::StoredSceneFit> records;
  for (const SceneFitRecord* record : store::in_order(contents.records)) {
    records.push_back(stored(*record));
  }
  io::Hdf5File file = io::Hdf5File::create(path, overwrite, contents.meta.threads);
  io::Hdf5Group& root = file.root();
  io::write_schema(root, kSceneFitSchema, kSceneFitVersion);
  io::write_run_id(root, contents.run);
  const std::vector<const store::StoredSceneFit*> pointers =
      store::pointers_to(std::span(std::as_const(records)));
  store::WrittenRows<store::StoredSceneFit> rows(root, pointers);
  store::traverse_scene_records(rows);
  const std::vector<const FitOutcome*> fits = store::outcomes_of(pointers);
  store::write_parameters(root, fits, store::parameters_of(fits));
  store::write_intervals(root, fits);
  root.write("options/confidence", contents.confidence, {"1"});
  io::write_inputs(root, contents.inputs);
  io::write_meta(root, contents.meta);
  rows.columns("meta", kSeconds);
  file.commit();
}

void put_in_order(std::vector<SceneFitRecord>& records) { store::sort_in_order(records); }

SceneFitContents read_scene_fit_store(const std::string& path) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  const io::Hdf5Group& root = file.root();
  const int version = io::check_schema(root, kSceneFitSchema, kOldestSceneFit, kSceneFitVersion);
  std::vector<store::StoredSceneFit> records(root.read_texts("fits/name").size());
  store::ReadRows<store::StoredSceneFit> rows({root, store::kFitRules, version},
                                              store::pointers_to(std::span(records)));
  store::traverse_scene_records(rows);
  rows.columns("meta", kSeconds);
  const std::vector<FitOutcome*> fits = store::outcomes_of(rows.rows());
  if (version >= 5) {
    store::read_parameters(root, version, 11, fits);
  } else {
    store::read_scene_parameters_4(root, version, fits);
  }
  store::read_intervals(root, fits);
  SceneFitContents contents;
  contents.run = io::read_run_id(root);
  for (store::StoredSceneFit& fit : records) {
    contents.records.push_back(record_of(std::move(fit), version));
    check_what_was_read(root, contents.records.back());
  }
  store::check_order(root, contents.records);
  contents.confidence = io::read_number<double>(root, "options/confidence", store::kFitRules);
  contents.inputs = io::read_inputs(root);
  contents.meta = io::read_meta(root);
  return contents;
}

}  // namespace plastica::calibrate
