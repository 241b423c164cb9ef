#include "sweeps/stability/scene_scan.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "plastica/base/parallel_for.hpp"
#include "plastica/model/section_kind.hpp"
#include "plastica/report/format.hpp"
#include "plastica/run/path_stops.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/stability/point_run.hpp"

namespace plastica::sweeps::stability {
namespace {

/// Values between the last valid one and the next that are tried.
constexpr int kBisections = 3;
/// Values of a grid on either side of the scene's own.
constexpr int kGridValues = 5;
/// From one value to the next.
const double kStep = std::sqrt(10.0);

double number_of(const Field& field, const Setup& setup) {
  const FieldValue value = field.get(setup);
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? std::nan("") : *number;
}

bool is_number(const Field& field) { return field.kind != FieldKind::Choice; }

/// Whether the section's shape has it.
bool is_dimension(const Setup& setup, const Field& field) {
  const auto own = section_kind(setup.scene.section.shape).dimensions();
  return field.path == "section.shear_coefficient" ||
         std::any_of(own.begin(), own.end(), [&](const Field& f) { return f.path == field.path; });
}

double whole_value(const Field& field, double value) {
  return field.kind == FieldKind::Integer ? std::round(value) : value;
}

StabilityRow point_row(const std::string& scene, const Setup& setup, std::vector<ScannedValue> at,
                       const JudgedRun& run) {
  StabilityRow row;
  row.scene = scene;
  row.id = scene + "/";
  for (const ScannedValue& value : at) {
    row.id += (&value == at.data() ? "" : ",") + value.axis + "=" + report::brief(value.value);
  }
  if (at.empty()) row.id += "own";
  row.level = run.level;
  row.analysis = setup.solver.analysis;
  row.at = std::move(at);
  row.begun = true;
  row.verdict = run.verdict;
  if (run.compared) {
    row.deviation = run.deviation;
    row.quantity = run.quantity;
  }
  row.status = run.outcome.status;
  row.energy_balance_error = run.energy_balance_error;
  row.segment_steps = run.segment_steps;
  row.seconds = run.seconds;
  return row;
}

ScannedValue scanned(const Field& field, double value) {
  return {std::string(field.path), std::string(si_unit(field.dimension)), value};
}

/// Runs values of one field, one after another.
class FieldScan {
 public:
  FieldScan(const std::string& scene, const Setup& setup, const Field& field,
            const PointRunner& runner, const SceneScanOptions& options)
      : scene_(scene), setup_(setup), field_(field), runner_(runner), options_(options) {}

  /// @param up  whether to larger values
  ScanLimit follow(bool up, const std::function<void()>& told) {
    const double own = number_of(field_, setup_);
    ScanLimit limit;
    limit.value = own;
    for (double factor = kStep; limit.end != ScanEnd::Verdict; factor *= kStep) {
      const double to = std::min(factor, options_.reach);
      const double value = whole_value(field_, up ? own * to : own / to);
      if (!field_.range.contains(value)) return ended(limit, ScanEnd::Range);
      if (value != limit.value) {
        if (!try_value(value, limit, told)) return limit;
      }
      if (limit.end != ScanEnd::Verdict && to == options_.reach) {
        return ended(limit, value == own ? ScanEnd::Whole : ScanEnd::Reach);
      }
    }
    narrow(limit, told);
    return limit;
  }

  std::vector<StabilityRow> rows() && { return std::move(rows_); }

 private:
  static ScanLimit ended(ScanLimit limit, ScanEnd end) {
    limit.end = end;
    return limit;
  }

  /// What a run takes for a value: a time step divides the time from one sample to the next.
  double taken_value(const Setup& setup, double value) const {
    const bool cut =
        field_.path == "solver.time_step" && setup.solver.analysis == Analysis::Dynamics;
    return cut ? taken_time_step(setup.scene, setup.solver) : value;
  }

  /// @return whether to go on
  bool try_value(double value, ScanLimit& limit, const std::function<void()>& told) {
    if (is_raised(options_.stop)) return false;
    Setup setup = setup_;
    JudgedRun run;
    try {
      set_field(setup, field_, value);
      value = taken_value(setup, value);
      if (value == limit.value) {
        if (limit.end != ScanEnd::Verdict) limit.end = ScanEnd::Samples;
        return false;
      }
      if (runner_.work(setup) > options_.max_work * runner_.own_work()) {
        limit = ended(limit, ScanEnd::Work);
        return false;
      }
      run = runner_.run(setup);
    } catch (const InputError& error) {
      run.outcome.status = Status::Rejected;
      run.verdict = {Validity::Failed, error.what()};
    }
    if (is_raised(options_.stop)) return false;
    rows_.push_back(point_row(scene_, setup, {scanned(field_, value)}, run));
    limit.changes = limit.changes || !runner_.is_own(run.outcome);
    told();
    if (run.verdict.validity == Validity::Valid) {
      limit.value = value;
    } else {
      limit.end = ScanEnd::Verdict;
      limit.next = value;
      limit.verdict = run.verdict;
    }
    return true;
  }

  /// Bisects, in factors, between the last valid value and the next.
  void narrow(ScanLimit& limit, const std::function<void()>& told) {
    for (int k = 0; k < kBisections; ++k) {
      const double between = limit.value * std::sqrt(limit.next / limit.value);
      const double value = whole_value(field_, between);
      if (value == limit.value || value == limit.next) return;
      if (!try_value(value, limit, told)) return;
    }
  }

  const std::string& scene_;
  const Setup& setup_;
  const Field& field_;
  const PointRunner& runner_;
  const SceneScanOptions& options_;
  std::vector<StabilityRow> rows_;
};

/// Counts points for the progress.
class PointCounter {
 public:
  explicit PointCounter(const SceneScanOptions& options) : options_(options) {}
  void count() {
    const std::lock_guard lock(mutex_);
    ++points_;
    if (options_.progress) options_.progress(points_);
  }

 private:
  const SceneScanOptions& options_;
  std::mutex mutex_;
  std::size_t points_ = 0;
};

const Field& varied_field(const std::string& name) {
  try {
    return find_axis_field(name);
  } catch (const InputError& error) {
    throw InputError({}, "--vary", name, error.rule());
  }
}

/// Where a grid ends in a direction: a step beyond the first value that is not valid.
double grid_end(double own, const ScanLimit& limit) {
  if (limit.end != ScanEnd::Verdict) return limit.value;
  return limit.next * (std::fabs(limit.next) > std::fabs(own) ? kStep : 1.0 / kStep);
}

/// Values from one end to the other, the scene's own among them, on either side evenly in factors.
std::vector<double> grid_values(const ScannedField& of) {
  const double own = of.value;
  std::vector<double> values;
  const auto add = [&](double end, int k) {
    const double part = static_cast<double>(k) / kGridValues;
    const double value = whole_value(*of.field, own * std::pow(end / own, part));
    const bool known = std::find(values.begin(), values.end(), value) != values.end();
    if (of.field->range.contains(value) && !known) values.push_back(value);
  };
  for (int k = kGridValues; k > 0; --k) add(grid_end(own, of.below), k);
  for (int k = 0; k <= kGridValues; ++k) add(grid_end(own, of.above), k);
  return values;
}

}  // namespace

std::vector<const Field*> scanned_fields(const Setup& setup,
                                         const std::vector<std::string>& names) {
  std::vector<const Field*> found;
  const auto is_there = [&](const Field& field) {
    const double value = number_of(field, setup);
    return std::isfinite(value) && value != 0.0;
  };
  for (const std::string& name : names) {
    const auto refuse = [&](const std::string& rule) {
      throw InputError({}, "--vary", name, rule);
    };
    const Field& field = varied_field(name);
    if (!is_number(field)) refuse("is a word, which has no factors");
    if (!is_there(field)) refuse("is not set, or 0, in the scene: there is nothing to multiply");
    if (std::find(found.begin(), found.end(), &field) != found.end()) refuse("is named twice");
    found.push_back(&field);
  }
  if (!names.empty()) return found;
  for (const auto fields_of : {fields(), derived_fields()}) {
    for (const Field& field : fields_of) {
      const bool of_result = field.path == "solver.buckling" ||
                             field.path == "solver.frequencies" || field.path == "solver.frames";
      // A size is the length and the section together.
      const bool other_shape = field.path.starts_with("section.") && !is_dimension(setup, field);
      const bool derived_size = field.path.starts_with("beam.s") && field.path != "beam.segments";
      if (is_number(field) && is_there(field) && !of_result && !other_shape && !derived_size) {
        found.push_back(&field);
      }
    }
  }
  return found;
}

SceneScan scan_scene(const std::string& name, const Setup& setup,
                     const std::vector<const Field*>& fields, const SceneScanOptions& options) {
  SceneScan scan;
  scan.scene = name;
  PointRunner runner(setup, options);
  const JudgedRun own = runner.run_own();
  if (is_raised(options.stop)) return scan;
  scan.own = own.verdict;
  scan.warnings = own.warnings;
  if (own.compared) {
    scan.deviation = own.deviation;
    scan.quantity = own.quantity;
  }
  scan.rows.push_back(point_row(name, setup, {}, own));
  if (own.verdict.validity != Validity::Valid) {
    scan.complete = true;
    return scan;
  }
  PointCounter counter(options);
  const auto told = [&counter] { counter.count(); };
  scan.fields.resize(fields.size());
  std::vector<std::vector<StabilityRow>> rows(2 * fields.size());
  parallel_for(rows.size(), {options.threads, options.stop}, [&](std::size_t i, int) {
    const Field& field = *fields[i / 2];
    const bool up = i % 2 != 0;
    FieldScan one(name, setup, field, runner, options);
    ScanLimit limit = one.follow(up, told);
    (up ? scan.fields[i / 2].above : scan.fields[i / 2].below) = std::move(limit);
    rows[i] = std::move(one).rows();
  });
  for (std::size_t f = 0; f < fields.size(); ++f) {
    scan.fields[f].field = fields[f];
    scan.fields[f].value = number_of(*fields[f], setup);
    for (const std::size_t i : {2 * f, 2 * f + 1}) {
      scan.rows.insert(scan.rows.end(), rows[i].begin(), rows[i].end());
    }
  }
  scan.complete = !is_raised(options.stop);
  return scan;
}

std::vector<StabilityRow> scan_pair(const std::string& name, const Setup& setup,
                                    const ScannedField& first, const ScannedField& second,
                                    const SceneScanOptions& options) {
  PointRunner runner(setup, options);
  runner.run_own();
  const std::vector<double> a = grid_values(first);
  const std::vector<double> b = grid_values(second);
  std::vector<StabilityRow> rows(a.size() * b.size());
  PointCounter counter(options);
  parallel_for(rows.size(), {options.threads, options.stop}, [&](std::size_t i, int) {
    const double x = a[i / b.size()];
    const double y = b[i % b.size()];
    Setup at = setup;
    JudgedRun run;
    try {
      set_field(at, *first.field, x);
      set_field(at, *second.field, y);
      if (runner.work(at) > options.max_work * runner.own_work()) return;
      run = runner.run(at);
    } catch (const InputError& error) {
      run.outcome.status = Status::Rejected;
      run.verdict = {Validity::Failed, error.what()};
    }
    if (is_raised(options.stop)) return;
    rows[i] = point_row(name, at, {scanned(*first.field, x), scanned(*second.field, y)}, run);
    counter.count();
  });
  std::erase_if(rows, [](const StabilityRow& row) { return !row.begun; });
  return rows;
}

}  // namespace plastica::sweeps::stability
