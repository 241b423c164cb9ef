#include "calibrate/store/fit_store.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>

#include "calibrate/fit/fitted_curve.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/layout.hpp"
#include "calibrate/store/older_parameters.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/stored_options.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

/// Whether the free parameters that a search has moved are some of those of its fit, in their
/// order.
bool are_moved(const std::vector<std::uint32_t>& moved, std::size_t parameters) {
  const bool rise = std::ranges::adjacent_find(moved, std::greater_equal<>()) == moved.end();
  return rise && (moved.empty() || moved.back() < parameters);
}

/// @throws std::logic_error
void check_to_write(const FitRecord& record, const FitOptions& options) {
  const auto refuse = [&](const char* why) {
    throw std::logic_error("write_fit_store: " + record.name() + " " + why);
  };
  const FitResult& r = record.result;
  const bool empty = r.cost == 0.0 && r.misfit_rms == 0.0 && r.misfit_fraction == 0.0;
  if (!r.is_fitted() && !(empty && r.misfit_word.empty())) {
    refuse("has a misfit without having been fitted");
  }
  const std::vector<Parameter> all = store::parameters_of(record, options);
  const auto same = [](const FittedParameter& p, const Parameter& q) {
    return p.path == q.field->path && p.role == q.role && p.dimension == q.field->dimension;
  };
  if (!r.parameters.empty() && !std::ranges::equal(r.parameters, all, same)) {
    refuse("has other parameters than the options");
  }
  if (!are_moved(r.trace.active, all.size())) {
    refuse("has other free parameters than the options have");
  }
}

void check_what_was_read(const io::Hdf5Group& root, const FitRecord& record,
                         const FitOptions& options) {
  const FitResult& result = record.result;
  if (result.is_fitted() && result.parameters.empty()) {
    io::refuse_value(root, "parameters", "", "must have a row for each fit that was made");
  }
  if (!are_moved(result.trace.active, store::parameters_of(record, options).size())) {
    io::refuse_value(root, "free", "", "must be parameters of the fit, in their order");
  }
  store::check_outcome(root, result, result.trace.active.size());
}

}  // namespace

void write_fit_store(const std::string& path, const FitStoreContents& contents,
                     io::Overwrite overwrite) {
  const std::vector<const FitRecord*> records = store::in_order(contents.records);
  for (const FitRecord* record : records) check_to_write(*record, contents.options);
  io::Hdf5File file = io::Hdf5File::create(path, overwrite, contents.meta.threads);
  io::Hdf5Group& root = file.root();
  io::write_schema(root, kFitStoreSchema, kFitStoreVersion);
  io::write_run_id(root, contents.run);
  store::WrittenRows<FitRecord> rows(root, records, [&](std::size_t i) {
    return remade_curve(records[i]->target, contents.options, records[i]->result);
  });
  store::traverse_records(rows);
  std::vector<store::StoredParameter> all;
  for (const Parameter& p : parameters_of(contents.options.laws, contents.options.parameters)) {
    all.push_back({std::string(p.field->path), p.field->dimension});
  }
  const std::vector<const FitOutcome*> fits = store::outcomes_of(records);
  store::write_parameters(root, fits, all);
  store::write_intervals(root, fits);
  io::Hdf5Group options = root.group("options");
  store::write_options(options, contents.options);
  io::write_inputs(root, contents.inputs);
  io::write_meta(root, contents.meta);
  file.commit();
}

void put_in_order(std::vector<FitRecord>& records) { store::sort_in_order(records); }

FitStoreContents read_fit_store(const std::string& path, FitSamples samples) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  const io::Hdf5Group& root = file.root();
  const int version = io::check_schema(root, kFitStoreSchema, kOldestFitStore, kFitStoreVersion);
  FitStoreContents contents;
  contents.run = io::read_run_id(root);
  contents.options = store::read_options(root.open_group("options"), version);
  std::vector<FitRecord>& records = contents.records;
  records.resize(root.read_texts("fits/name").size());
  if (!contents.options.laws.empty()) samples = FitSamples::Read;
  store::ReadRows<FitRecord> rows({root, store::kFitRules, version, samples},
                                  store::pointers_to(std::span(records)));
  store::traverse_records(rows);
  const std::vector<FitOutcome*> fits = store::outcomes_of(rows.rows());
  if (version >= 5) {
    store::read_parameters(root, version, 9, fits);
  } else {
    store::read_parameters_4(root, version, records, contents.options);
  }
  store::read_intervals(root, fits);
  for (const FitRecord& record : records) check_what_was_read(root, record, contents.options);
  store::check_order(root, records);
  contents.inputs = io::read_inputs(root);
  contents.meta = io::read_meta(root);
  return contents;
}

}  // namespace plastica::calibrate
