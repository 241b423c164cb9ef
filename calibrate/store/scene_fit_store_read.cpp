#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "calibrate/result/describe_fit.hpp"
#include "calibrate/result/describe_target.hpp"
#include "calibrate/store/fit_rules.hpp"
#include "calibrate/store/interval_store.hpp"
#include "calibrate/store/older_parameters.hpp"
#include "calibrate/store/parameter_tables.hpp"
#include "calibrate/store/scene_fit_store.hpp"
#include "calibrate/store/tables.hpp"

namespace plastica::calibrate {
namespace {

/// Fills records from a file, of which it knows how many there are.
class Reader {
 public:
  Reader(const io::Hdf5Group& root, int version, std::vector<SceneFitRecord>& records)
      : tables_(root, kRules, version), records_(store::pointers_to(std::span(records))) {}

  void fits() { tables_.columns("fits", records_, kDescribeSceneFit); }

  void parameters() {
    if (tables_.version() >= 5) {
      std::vector<FitOutcome*> fits;
      for (SceneFitRecord* record : records_) fits.push_back(&record->result);
      store::read_parameters(tables_.root(), tables_.version(), fits);
    } else {
      store::read_scene_parameters_4(tables_.root(), tables_.version(), records_);
    }
    const auto correlation = tables_.lists("correlation", records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      SceneFitResult& result = records_[i]->result;
      const std::size_t n = result.parameters.size();
      result.correlation = numbers(correlation.row(i));
      if (!result.correlation.empty() && result.correlation.size() != n * n) {
        refuse("correlation", "must have a row and a column for each parameter of a fit");
      }
    }
    if (tables_.version() < 8) return;
    const auto held_out = tables_.lists("held_out", records_.size());
    for (std::size_t i = 0; i < records_.size(); ++i) {
      store::check_parts(tables_.root(), "held_out", held_out.row(i).size());
      records_[i]->result.held_out = numbers(held_out.row(i));
    }
  }

  void segments() {
    const auto member = [this](SceneFitRecord & record) -> auto& {
      if (!record.result.segments) refuse("segments/fit", "names a fit that was not remeshed");
      return record.result.segments->parameters;
    };
    (void)tables_.items("segments", records_, member, kDescribeSegments);
    for (const SceneFitRecord* record : records_) {
      const SceneFitResult& result = record->result;
      if (result.segments && result.segments->parameters.size() != result.parameters.size()) {
        refuse("segments/fit", "must have a row for each parameter of a fit");
      }
    }
  }

  void targets() {
    const auto targets =
        tables_.items("targets", records_, PLASTICA_MEMBER(targets), kDescribeSceneTarget);
    const std::size_t n = targets.rows.size();
    std::vector<TargetRow> rows(n);
    tables_.columns("targets", store::pointers_to(std::span(rows)), [](auto& d) {
      d("weight", "1", PLASTICA_MEMBER(weight));
      d("has_curve", "", PLASTICA_MEMBER(has_curve));
      d.optional("present", PLASTICA_MEMBER(made), kDescribeTargetFit);
    });
    if (tables_.version() >= 6) {
      (void)tables_.items("repairs", targets.rows, PLASTICA_MEMBER(repairs), kDescribeRepair,
                          "target");
    }
    const io::Ragged<double> abscissa = curve("abscissa", n);
    const io::Ragged<double> ordinate = curve("ordinate", n);
    const io::Ragged<double> fitted = curve("fitted", n);
    const io::Ragged<double> error = curve("fitted_error", n);
    for (std::size_t p = 0; p < n; ++p) {
      SceneFitRecord& record = *records_[targets.fits[p]];
      targets.rows[p]->abscissa = numbers(abscissa.row(p));
      targets.rows[p]->ordinate = numbers(ordinate.row(p));
      record.weights.push_back(rows[p].weight);
      if (!rows[p].made) continue;
      TargetFit& made = record.result.targets.emplace_back(std::move(*rows[p].made));
      made.name = targets.rows[p]->name;
      if (tables_.version() < 7) made.law = record.result.law;
      if (!rows[p].has_curve) continue;
      made.fitted = numbers(fitted.row(p));
      made.fitted_error = numbers(error.row(p));
    }
    check_targets();
  }

  void starts() {
    const auto starts =
        tables_.items("starts", records_, PLASTICA_MEMBER(result.starts), kDescribeStart);
    const auto from = tables_.lists("starts/from", starts.rows.size());
    const auto to = tables_.lists("starts/to", starts.rows.size());
    for (std::size_t s = 0; s < starts.rows.size(); ++s) {
      SceneStart& start = *starts.rows[s];
      start.from = numbers(from.row(s));
      start.to = numbers(to.row(s));
      if (!start.to.empty() && start.to.size() != start.from.size()) {
        refuse("starts/to", "must have a value for each parameter that is searched");
      }
    }
  }

  void warnings() {
    (void)tables_.items("warnings", records_, PLASTICA_MEMBER(result.warnings), kDescribeText);
  }

 private:
  static constexpr std::span<const io::ValueRule> kRules{store::kSceneFitRules};

  /// Of a target what its own description does not have.
  struct TargetRow {
    double weight = 1.0;
    bool has_curve = false;         ///< whether the fitted ordinates are there
    std::optional<TargetFit> made;  ///< empty: the fit has nothing of it
  };

  [[noreturn]] void refuse(const std::string& path, const std::string& rule) const {
    tables_.refuse(path, rule);
  }

  void check_targets() const {
    for (const SceneFitRecord* record : records_) {
      const std::size_t made = record->result.targets.size();
      if (record->targets.empty()) refuse("targets/fit", "must name each fit");
      const bool found = record->result.status == FitStatus::Fitted;
      if (found && (made == 0 || record->result.parameters.empty())) {
        refuse("targets/present", "must hold for each fit that was made");
      }
      if (made != 0 && made != record->targets.size()) {
        refuse("targets/present", "must be the same for all targets of a fit");
      }
    }
  }

  io::Ragged<double> curve(const std::string& name, std::size_t n) const {
    io::Ragged<double> rows;
    rows.values = io::read_numbers<double>(tables_.root(), "curves/" + name, kRules);
    rows.offsets = tables_.root().read<std::uint64_t>("curves/offsets");
    const std::vector<std::uint64_t>& offsets = rows.offsets;
    const bool fits = offsets.size() == n + 1 && offsets.front() == 0 &&
                      offsets.back() == rows.values.size() && std::ranges::is_sorted(offsets);
    if (!fits) refuse("curves/" + name, "has offsets that do not fit its values");
    return rows;
  }

  static std::vector<double> numbers(std::span<const double> row) {
    return {row.begin(), row.end()};
  }

  store::TableReader tables_;
  std::vector<SceneFitRecord*> records_;
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
  reader.targets();
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
