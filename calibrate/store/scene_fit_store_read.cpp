#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "calibrate/store/columns.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/scene_fit_rows.hpp"
#include "calibrate/store/scene_fit_store.hpp"

namespace plastica::calibrate {
namespace {

/// Fills records from a file, of which it knows how many there are.
class Reader {
 public:
  Reader(const io::Hdf5Group& root, int version, std::vector<SceneFitRecord>& records)
      : root_(root), version_(version), records_(records) {}

  void fits() {
    read_columns("fits", store::pointers_to(std::span(records_)), store::kSceneFitColumns);
  }

  void parameters() {
    auto rows = table<store::SceneParameterRow>("parameters", store::kSceneParameterColumns);
    std::vector<FittedParameter*> described;
    for (store::SceneParameterRow& row : rows) described.push_back(&row.parameter);
    if (version_ == 3) {
      read_parameters_3(described);
    } else {
      read_columns("parameters", std::move(described), kDescribeParameter);
    }
    for (store::SceneParameterRow& row : rows) {
      if (find_field_or_null(row.parameter.path) == nullptr) {
        io::refuse_value(root_, "parameters/path", row.parameter.path, "must be a field");
      }
      records_[row.fit].result.parameters.push_back(std::move(row.parameter));
    }
    const auto correlation = ragged("correlation", records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      SceneFitResult& result = records_[i].result;
      const std::size_t n = result.parameters.size();
      result.correlation = numbers(correlation.row(i));
      if (!result.correlation.empty() && result.correlation.size() != n * n) {
        refuse("correlation", "must have a row and a column for each parameter of a fit");
      }
    }
  }

  void segments() {
    for (auto& row : table<store::SceneSegmentsRow>("segments", store::kSceneSegmentsColumns)) {
      auto& made = records_[row.fit].result.segments;
      if (!made) refuse("segments/fit", "names a fit that was not divided anew");
      made->parameters.push_back(row.error);
    }
    for (const SceneFitRecord& record : records_) {
      const SceneFitResult& result = record.result;
      if (result.segments && result.segments->parameters.size() != result.parameters.size()) {
        refuse("segments/fit", "must have a row for each parameter of a fit");
      }
    }
  }

  void parts() {
    auto rows = table<store::ScenePartRow>("parts", store::kScenePartColumns);
    const io::Ragged<double> abscissa = curve("abscissa", rows.size());
    const io::Ragged<double> ordinate = curve("ordinate", rows.size());
    const io::Ragged<double> fitted = curve("fitted", rows.size());
    const io::Ragged<double> error = curve("fitted_error", rows.size());
    for (std::size_t p = 0; p < rows.size(); ++p) {
      store::ScenePartRow& row = rows[p];
      SceneFitRecord& record = records_[row.fit];
      row.target.abscissa = numbers(abscissa.row(p));
      row.target.ordinate = numbers(ordinate.row(p));
      if (row.made) {
        row.made->name = row.target.name;
        if (row.has_curve) {
          row.made->fitted = numbers(fitted.row(p));
          row.made->fitted_error = numbers(error.row(p));
        }
        record.result.parts.push_back(std::move(*row.made));
      }
      record.targets.push_back(std::move(row.target));
      record.weights.push_back(row.weight);
    }
    for (const SceneFitRecord& record : records_) {
      const std::size_t made = record.result.parts.size();
      if (record.targets.empty()) refuse("parts/fit", "must name each fit");
      const bool found = record.result.status == FitStatus::Fitted;
      if (found && (made == 0 || record.result.parameters.empty())) {
        refuse("parts/present", "must hold for each fit that was made");
      }
      if (made != 0 && made != record.targets.size()) {
        refuse("parts/present", "must be the same for all targets of a fit");
      }
    }
  }

  void starts() {
    auto rows = table<store::SceneStartRow>("starts", store::kSceneStartColumns);
    const auto from = ragged("starts/from", rows.size());
    const auto to = ragged("starts/to", rows.size());
    for (std::size_t s = 0; s < rows.size(); ++s) {
      rows[s].start.from = numbers(from.row(s));
      rows[s].start.to = numbers(to.row(s));
      SceneFitResult& result = records_[rows[s].fit].result;
      const SceneStart& start = rows[s].start;
      if (!start.to.empty() && start.to.size() != start.from.size()) {
        refuse("starts/to", "must have a value for each parameter that is searched");
      }
      result.starts.push_back(std::move(rows[s].start));
    }
  }

  void warnings() {
    for (auto& row : table<store::SceneWarningRow>("warnings", store::kSceneWarningColumns)) {
      records_[row.fit].result.warnings.push_back(std::move(row.text));
    }
  }

 private:
  static constexpr std::span<const io::ValueRule> kRules{store::kSceneFitRules};

  [[noreturn]] void refuse(const std::string& path, const std::string& rule) const {
    io::refuse_value(root_, path, "", rule);
  }

  /// Version 3 says that a parameter is at a bound, but not at which, and knows no coordinates.
  void read_parameters_3(const std::vector<FittedParameter*>& parameters) const {
    struct Row : FittedParameter {
      bool is_at_bound = false;
      Judgement judged;
    };
    std::vector<Row> rows(parameters.size());
    read_columns("parameters", store::pointers_to(std::span(rows)), [](auto& columns) {
      columns("value", "", PLASTICA_MEMBER(value));
      columns("start", "", PLASTICA_MEMBER(start));
      columns("lower", "", PLASTICA_MEMBER(lower));
      columns("upper", "", PLASTICA_MEMBER(upper));
      columns("standard_error", "", PLASTICA_MEMBER(standard_error));
      columns("noise_error", "", PLASTICA_MEMBER(noise_error));
      columns("sampling_error", "", PLASTICA_MEMBER(sampling_error));
      columns("misfit_error", "", PLASTICA_MEMBER(misfit_error));
      columns("interval_low", "", PLASTICA_MEMBER(interval_low));
      columns("interval_high", "", PLASTICA_MEMBER(interval_high));
      columns("degrees_of_freedom", "1", PLASTICA_MEMBER(degrees_of_freedom));
      columns("at_bound", "", PLASTICA_MEMBER(is_at_bound));
      columns("verdict", "", PLASTICA_MEMBER(judged.verdict));
      columns("verdict_number", "", PLASTICA_MEMBER(judged.number));
    });
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Row& row = rows[i];
      row.path = parameters[i]->path;
      row.dimension = parameters[i]->dimension;
      row.judgement = row.judged;
      row.identified = row.judged.verdict != Verdict::NotIdentified;
      row.logarithmic = row.lower > 0.0;
      const bool low = std::abs(row.value - row.lower) <= std::abs(row.upper - row.value);
      row.at_lower = row.is_at_bound && low;
      row.at_upper = row.is_at_bound && !low;
      *parameters[i] = std::move(static_cast<FittedParameter&>(row));
    }
  }

  template <typename Row, typename Columns>
  void read_columns(const std::string& path, std::vector<Row*> rows, const Columns& columns) const {
    const io::Hdf5Group group = root_.open_group(path);
    store::ColumnReader<Row> reader(group, std::move(rows), kRules, version_);
    columns(reader);
  }

  template <typename Row, typename Columns>
  std::vector<Row> table(const std::string& path, const Columns& columns) const {
    std::vector<Row> rows(root_.read<std::uint64_t>(path + "/fit").size());
    read_columns(path, store::pointers_to(std::span(rows)), columns);
    for (const Row& row : rows) {
      if (row.fit >= records_.size()) refuse(path + "/fit", "names a fit that is not in the file");
    }
    return rows;
  }

  io::Ragged<double> ragged(const std::string& path, std::size_t n) const {
    return io::read_lists(root_, path, n, kRules);
  }

  io::Ragged<double> curve(const std::string& name, std::size_t n) const {
    io::Ragged<double> rows;
    rows.values = io::read_numbers<double>(root_, "curves/" + name, kRules);
    rows.offsets = root_.read<std::uint64_t>("curves/offsets");
    const std::vector<std::uint64_t>& offsets = rows.offsets;
    const bool whole = offsets.size() == n + 1 && offsets.front() == 0 &&
                       offsets.back() == rows.values.size() && std::ranges::is_sorted(offsets);
    if (!whole) refuse("curves/" + name, "has offsets that do not fit its values");
    return rows;
  }

  static std::vector<double> numbers(std::span<const double> row) {
    return {row.begin(), row.end()};
  }

  const io::Hdf5Group& root_;
  int version_;
  std::vector<SceneFitRecord>& records_;
};

/// Reports find the fits of a name beside each other, and a fit by its name and law.
void check_order(const io::Hdf5Group& root, const std::vector<SceneFitRecord>& records) {
  const auto follows = [](const SceneFitRecord& a, const SceneFitRecord& b) {
    return std::pair(std::string_view(a.name), a.result.law) >=
           std::pair(std::string_view(b.name), b.result.law);
  };
  if (std::ranges::adjacent_find(records, follows) != records.end()) {
    io::refuse_value(root, "fits/name", "", "must rise, or be the same with a law that rises");
  }
}

}  // namespace

SceneFitContents read_scene_fit_store(const std::string& path) {
  const io::Hdf5File file = io::Hdf5File::open(path);
  const io::Hdf5Group& root = file.root();
  const int version = io::check_schema(root, kSceneFitSchema, kOldestSceneFit, kSceneFitVersion);
  SceneFitContents contents;
  contents.run = io::read_run_id(root);
  contents.records.resize(root.read_texts("fits/name").size());
  Reader reader(root, version, contents.records);
  reader.fits();
  reader.parameters();
  reader.segments();
  reader.parts();
  reader.starts();
  reader.warnings();
  std::vector<FitIntervals*> intervals;
  for (SceneFitRecord& record : contents.records) intervals.push_back(&record.result.intervals);
  store::read_intervals(root, intervals);
  for (const SceneFitRecord& record : contents.records) {
    store::check_intervals(root, record.result.intervals, record.result.parameters.size());
  }
  check_order(root, contents.records);
  contents.confidence = io::read_number<double>(root, "options/confidence", store::kSceneFitRules);
  contents.inputs = io::read_inputs(root);
  contents.meta = io::read_meta(root);
  const auto seconds = io::read_numbers<double>(root, "meta/fit_seconds", store::kSceneFitRules);
  if (seconds.size() != contents.records.size()) {
    throw InputError({path, 0}, "/meta/fit_seconds", std::to_string(seconds.size()),
                     "must have a row for each fit");
  }
  for (std::size_t i = 0; i < seconds.size(); ++i) contents.records[i].seconds = seconds[i];
  return contents;
}

}  // namespace plastica::calibrate
