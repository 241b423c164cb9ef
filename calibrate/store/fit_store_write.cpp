#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/layout.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/stored_options.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw std::logic_error("write_fit_store: " + name + " " + why);
}

/// Writes the records in the order in which they are given.
class StoreWriter {
 public:
  StoreWriter(io::Hdf5Group& root, std::vector<const FitRecord*> records, const FitOptions& options)
      : root_(root), records_(std::move(records)), options_(options) {}

  template <typename Columns, typename Member>
  void table(const std::string& path, const Columns& columns, const Member& member) {
    using Row = std::remove_cvref_t<decltype(member(*records_[0]))>;
    std::vector<const Row*> rows;
    for (const FitRecord* record : records_) rows.push_back(&member(*record));
    io::Hdf5Group group = root_.group(path);
    store::write_columns(group, std::move(rows), columns);
  }

  template <typename Member, typename Columns>
  void list(const std::string& path, const Member& member, const Columns& columns) {
    store::write_items(root_, path, store::items_of(records_, member), columns);
  }

  /// Numbers of each record.
  template <typename Member>
  void numbers_since(int /*version*/, const std::string& path, const Member& member) {
    io::Ragged<double> rows;
    for (const FitRecord* record : records_) rows.push_back(member(*record));
    root_.write_ragged(path, rows, {"1", store::kDeflate});
  }

  template <typename Member>
  void curve(const std::string& path, const Member& member) {
    Curve all;
    std::vector<std::uint64_t> offsets{0};
    for (const FitRecord* record : records_) {
      const Curve& curve = member(*record);
      if (curve.strain.size() != curve.stress.size()) {
        refuse(record->target.name, "has a curve with more strains than stresses or fewer");
      }
      all.strain.insert(all.strain.end(), curve.strain.begin(), curve.strain.end());
      all.stress.insert(all.stress.end(), curve.stress.begin(), curve.stress.end());
      offsets.push_back(all.size());
    }
    root_.write(path + "/strain", all.strain, {"1", store::kDeflate});
    root_.write(path + "/stress", all.stress, {"Pa", store::kDeflate});
    root_.write(path + "/offsets", offsets, {{}, store::kDeflate});
  }

  void parameters() {
    std::vector<const FitOutcome*> fits;
    for (const FitRecord* record : records_) {
      const auto& own = record->result.parameters;
      const auto same = [](const FittedParameter& p, const Parameter& q) {
        return p.path == q.field->path && p.role == q.role && p.dimension == q.field->dimension;
      };
      const std::vector<Parameter> all = store::parameters_of(*record, options_);
      if (!own.empty() && !std::equal(own.begin(), own.end(), all.begin(), all.end(), same)) {
        refuse(record->target.name, "has other parameters than the options");
      }
      fits.push_back(&record->result);
    }
    std::vector<store::StoredParameter> all;
    for (const Parameter& p : parameters_of(options_.laws, options_.parameters)) {
      all.push_back({std::string(p.field->path), p.field->dimension, p.role});
    }
    store::write_parameters(root_, fits, all);
  }

  void free_parameters() {
    io::Ragged<std::uint64_t> rows;
    std::vector<std::uint64_t> counts;
    for (const FitRecord* record : records_) {
      const auto& active = record->result.trace.active;
      const std::vector<std::uint64_t> row(active.begin(), active.end());
      const bool rising =
          std::adjacent_find(row.begin(), row.end(), std::greater_equal<>()) == row.end();
      const std::size_t count = store::parameters_of(*record, options_).size();
      if (!rising || (!row.empty() && row.back() >= count)) {
        refuse(record->target.name, "has other free parameters than the options have");
      }
      rows.push_back(row);
      counts.push_back(row.size());
    }
    root_.write_ragged("free", rows, {{}, store::kDeflate});
    root_.write("fits/free_parameters", counts, {"1", store::kDeflate});  // for other readers
  }

  void correlation() {
    io::Ragged<double> rows;
    for (const FitRecord* record : records_) rows.push_back(record->result.correlation);
    root_.write_ragged("correlation", rows, {"1", store::kDeflate});
  }

  void intervals() {
    std::vector<store::StoredIntervals> all;
    for (const FitRecord* record : records_) {
      store::StoredIntervals& one = all.emplace_back();
      one.intervals = &record->result.intervals;
      for (const FittedParameter* p : record->result.free_parameters()) {
        one.paths.push_back(p->path);
      }
      const std::size_t profiles = one.intervals->profiles.size();
      if (profiles != 0 && profiles != one.paths.size()) {
        refuse(record->target.name, "has not a profile a free parameter");
      }
    }
    store::write_intervals(root_, all);
  }

  void evaluations() {
    std::size_t width = 0;
    std::vector<double> costs;
    std::vector<std::uint64_t> offsets{0};
    for (const FitRecord* record : records_) {
      const Trace& trace = record->result.trace;
      if (trace.values.size() != trace.costs.size() * trace.active.size()) {
        refuse(record->target.name, "has a trace whose values do not fit its costs");
      }
      width = std::max(width, trace.active.size());
      costs.insert(costs.end(), trace.costs.begin(), trace.costs.end());
      offsets.push_back(costs.size());
    }
    // A fit that moves fewer parameters than another leaves the last columns of its rows empty.
    std::vector<double> values(costs.size() * width, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const Trace& trace = records_[i]->result.trace;
      for (std::size_t k = 0; k < trace.costs.size(); ++k) {
        std::copy_n(&trace.values[k * trace.active.size()], trace.active.size(),
                    &values[(offsets[i] + k) * width]);
      }
    }
    root_.write("evaluations/cost", costs, {"Pa^2", store::kDeflate});
    root_.write_table<double>("evaluations/values", values, width, {{}, store::kDeflate});
    root_.write("evaluations/offsets", offsets, {{}, store::kDeflate});
  }

 private:
  io::Hdf5Group& root_;
  std::vector<const FitRecord*> records_;
  const FitOptions& options_;
};

/// Pointers to the records, sorted by name and law, and checked.
std::vector<const FitRecord*> by_name(const std::vector<FitRecord>& records) {
  std::vector<const FitRecord*> sorted;
  sorted.reserve(records.size());
  for (const FitRecord& record : records) sorted.push_back(&record);
  const auto before = [](const FitRecord* a, const FitRecord* b) {
    if (a->target.name != b->target.name) return a->target.name < b->target.name;
    return a->result.law < b->result.law;
  };
  std::sort(sorted.begin(), sorted.end(), before);
  const auto same = [](const FitRecord* a, const FitRecord* b) {
    return a->target.name == b->target.name && a->result.law == b->result.law;
  };
  for (const FitRecord* record : sorted) {
    const FitResult& r = record->result;
    const bool empty = r.cost == 0.0 && r.misfit_rms == 0.0 && r.misfit_fraction == 0.0;
    if (r.status != FitStatus::Fitted && !(empty && r.misfit_word.empty())) {
      refuse(record->target.name, "has a misfit without having been fitted");
    }
  }
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end(), same);
  if (twice != sorted.end()) refuse((*twice)->target.name, "is the name of two targets");
  return sorted;
}

}  // namespace

void write_fit_store(const std::string& path, const FitStoreContents& contents,
                     io::Overwrite overwrite) {
  std::vector<const FitRecord*> records = by_name(contents.records);
  io::Hdf5File file = io::Hdf5File::create(path, overwrite);
  io::Hdf5Group& root = file.root();
  io::write_schema(root, kFitStoreSchema, kFitStoreVersion);
  io::write_run_id(root, contents.run);
  StoreWriter writer(root, std::move(records), contents.options);
  store::traverse_records(writer);
  io::Hdf5Group options = root.group("options");
  store::write_options(options, contents.options);
  io::write_inputs(root, contents.inputs);
  io::write_meta(root, contents.meta);
  file.commit();
}

}  // namespace plastica::calibrate
