#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/fit_store.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/layout.hpp"
#include "calibrate/store/older_parameters.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/stored_options.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

/// Fills records from a file, of which it knows how many there are.
class StoreReader {
 public:
  StoreReader(const io::Hdf5Group& root, int version, std::vector<FitRecord>& records,
              const FitOptions& options)
      : tables_(root, kRules, version), root_(root), records_(records), options_(options) {}

  template <typename Columns, typename Member>
  void table(const std::string& path, const Columns& columns, const Member& member) {
    using Row = std::remove_cvref_t<decltype(member(records_[0]))>;
    std::vector<Row*> rows;
    rows.reserve(records_.size());
    for (FitRecord& record : records_) rows.push_back(&member(record));
    tables_.columns(path, std::move(rows), columns);
  }

  template <typename Member, typename Columns>
  void list(const std::string& path, const Member& member, const Columns& columns) {
    (void)tables_.items(path, store::pointers_to(std::span(records_)), member, columns);
  }

  template <typename Member>
  void numbers_since(int version, const std::string& path, const Member& member) {
    if (tables_.version() < version) return;
    const auto rows = tables_.lists(path, records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      store::check_parts(root_, path, rows.row(i).size());
      member(records_[i]).assign(rows.row(i).begin(), rows.row(i).end());
    }
  }

  template <typename Member>
  void curve(const std::string& path, const Member& member) {
    const auto offsets = root_.read<std::uint64_t>(path + "/offsets");
    const auto strain = numbers(path + "/strain");
    const auto stress = numbers(path + "/stress");
    check_offsets(path, offsets, strain.size());
    check_offsets(path, offsets, stress.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      member(records_[i]) = {cut(strain, offsets[i], offsets[i + 1]),
                             cut(stress, offsets[i], offsets[i + 1])};
    }
  }

  void parameters() {
    if (tables_.version() >= 5) {
      std::vector<FitOutcome*> fits;
      for (FitRecord& record : records_) fits.push_back(&record.result);
      store::read_parameters(root_, tables_.version(), fits);
    } else {
      store::read_parameters_4(root_, tables_.version(), records_, options_);
    }
    for (const FitRecord& record : records_) {
      if (record.result.is_fitted() && record.result.parameters.empty()) {
        refuse("parameters", "must have a row for each fit that was made");
      }
    }
  }

  void free_parameters() {
    const auto rows = root_.read_ragged<std::uint64_t>("free");
    check_offsets("free", rows.offsets, rows.values.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const auto row = rows.row(i);
      const bool rises = std::ranges::adjacent_find(row, std::greater_equal<>()) == row.end();
      const std::size_t parameters = store::parameters_of(records_[i], options_).size();
      if (!rises || (!row.empty() && row.back() >= parameters)) {
        refuse("free", "must be parameters of the fit, in their order");
      }
      for (const std::uint64_t index : row) {
        records_[i].result.trace.active.push_back(static_cast<std::uint32_t>(index));
      }
    }
  }

  void correlation() {
    const auto rows = io::read_lists(root_, "correlation", records_.size(), kRules);
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const auto row = rows.row(i);
      const std::size_t count = records_[i].result.trace.active.size();
      if (!row.empty() && row.size() != count * count) {
        refuse("correlation", "must have a row and a column for each free parameter");
      }
      records_[i].result.correlation.assign(row.begin(), row.end());
    }
  }

  void intervals() {
    std::vector<FitIntervals*> all;
    for (FitRecord& record : records_) all.push_back(&record.result.intervals);
    store::read_intervals(root_, all);
    for (const FitRecord& record : records_) {
      store::check_intervals(root_, record.result.intervals,
                             record.result.free_parameters().size());
    }
  }

  void evaluations() {
    const auto offsets = root_.read<std::uint64_t>("evaluations/offsets");
    const auto costs = numbers("evaluations/cost");
    check_offsets("evaluations", offsets, costs.size());
    const std::array shape{costs.size(), io::Hdf5Group::kAnyExtent};
    const auto values = root_.read_array<double>("evaluations/values", shape);
    io::check_values(root_, "evaluations/values", values,
                     io::rule_of(kRules, "evaluations/values"));
    const std::size_t columns = root_.shape("evaluations/values")[1];
    for (std::size_t i = 0; i < records_.size(); ++i) {
      Trace& trace = records_[i].result.trace;
      const std::size_t width = trace.active.size();
      if (width > columns) {
        refuse("evaluations/values", "has fewer columns than a fit has free parameters");
      }
      trace.costs = cut(costs, offsets[i], offsets[i + 1]);
      trace.values.reserve(trace.costs.size() * width);
      for (std::size_t k = offsets[i]; k < offsets[i + 1]; ++k) {
        const auto row = values.begin() + static_cast<std::ptrdiff_t>(k * columns);
        const auto end = row + static_cast<std::ptrdiff_t>(width);
        trace.values.insert(trace.values.end(), row, end);
      }
    }
  }

 private:
  static constexpr std::span<const io::ValueRule> kRules{store::kFitRules};

  [[noreturn]] void refuse(const std::string& path, const std::string& rule) const {
    io::refuse_value(root_, path, "", rule);
  }

  std::vector<double> numbers(const std::string& path) const {
    return io::read_numbers<double>(root_, path, kRules);
  }

  void check_offsets(const std::string& path, const std::vector<std::uint64_t>& offsets,
                     std::size_t size) const {
    const bool fits = offsets.size() == records_.size() + 1 && offsets.front() == 0 &&
                      offsets.back() == size && std::is_sorted(offsets.begin(), offsets.end());
    if (!fits) refuse(path, "has offsets that do not fit its values");
  }

  static std::vector<double> cut(const std::vector<double>& all, std::uint64_t from,
                                 std::uint64_t to) {
    return {all.begin() + static_cast<std::ptrdiff_t>(from),
            all.begin() + static_cast<std::ptrdiff_t>(to)};
  }

  store::TableReader tables_;
  const io::Hdf5Group& root_;
  std::vector<FitRecord>& records_;
  const FitOptions& options_;
};

/// Reports find the fits of a target beside each other, and a fit by its name and law.
void check_order(const io::Hdf5Group& root, const std::vector<FitRecord>& records) {
  const auto follows = [](const FitRecord& a, const FitRecord& b) {
    return std::pair(std::string_view(a.target.name), a.result.law) >=
           std::pair(std::string_view(b.target.name), b.result.law);
  };
  if (std::ranges::adjacent_find(records, follows) != records.end()) {
    io::refuse_value(root, "fits/name", "", "must rise, or be the same with a law that rises");
  }
}

}  // namespace

FitStoreContents read_fit_store(const std::string& path) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  const io::Hdf5Group& root = file.root();
  const int version = io::check_schema(root, kFitStoreSchema, kOldestFitStore, kFitStoreVersion);
  FitStoreContents contents;
  contents.run = io::read_run_id(root);
  contents.options = store::read_options(root.open_group("options"), version);
  contents.records.resize(root.read_texts("fits/name").size());
  StoreReader reader(root, version, contents.records, contents.options);
  store::traverse_records(reader);
  check_order(root, contents.records);
  contents.inputs = io::read_inputs(root);
  contents.meta = io::read_meta(root);
  return contents;
}

}  // namespace plastica::calibrate
