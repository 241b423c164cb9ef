#include "sweeps/stability/scene_scan.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plastica/model/section_kind.hpp"
#include "plastica/run/path_stops.hpp"
#include "sweeps/plan/derived_fields.hpp"
#include "sweeps/stability/point_run.hpp"
#include "sweeps/stability/scan_work.hpp"

namespace plastica::sweeps::stability {
namespace {

/// Values between the last valid one and the next that are tried.
constexpr int kBisections = 3;

bool is_number(const Field& field) { return field.kind != FieldKind::Choice; }

/// Whether the section's shape has it.
bool is_dimension(const Setup& setup, const Field& field) {
  const auto own = section_kind(setup.scene.section.shape).dimensions();
  return field.path == "section.shear_coefficient" ||
         std::any_of(own.begin(), own.end(), [&](const Field& f) { return f.path == field.path; });
}

/// Runs values of one field, one after another.
class FieldScan {
 public:
  FieldScan(const std::string& scene, const Setup& setup, const Field& field,
            const PointRunner& runner, const SceneScanOptions& options, Source source)
      : scene_(scene),
        setup_(setup),
        field_(field),
        runner_(runner),
        options_(options),
        source_(source) {}

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
  /// Whether it was stopped before its end.
  bool stopped() const { return stopped_; }

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
    Setup setup = setup_;
    std::optional<JudgedRun> run;
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
      run = runner_.run(setup, source_);
    } catch (const InputError& error) {
      run = refused(error);
    }
    if (!run) {
      stopped_ = true;
      return false;
    }
    rows_.push_back(point_row(scene_, setup, {scanned(field_, value)}, *run));
    limit.changes = limit.changes || !run->as_own;
    told();
    if (run->verdict.validity == Validity::Valid) {
      limit.value = value;
    } else {
      limit.end = ScanEnd::Verdict;
      limit.next = value;
      limit.verdict = run->verdict;
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
  Source source_;
  bool stopped_ = false;
  std::vector<StabilityRow> rows_;
};

/// What one direction of a field came to.
struct Direction {
  ScanLimit limit{};
  std::vector<StabilityRow> rows{};
  bool done = false;
};

const Field& varied_field(const std::string& name) {
  try {
    return find_axis_field(name);
  } catch (const InputError& error) {
    throw InputError({}, "--vary", name, error.rule());
  }
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
    for (const Field* other : found) {
      if (set_one_number(field, *other)) {
        refuse("sets the same number as " + std::string(other->path));
      }
    }
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
  if (!is_raised(options.stop)) {
    scan.own = own.verdict;
    scan.warnings = own.warnings;
    if (own.compared) {
      scan.deviation = own.deviation;
      scan.quantity = own.quantity;
    }
    scan.rows.push_back(point_row(name, setup, {}, own));
    scan.complete = own.verdict.validity != Validity::Valid;
  }
  if (scan.complete) return scan;

  // Others of a team wait for this process there, even where it was stopped.
  std::vector<Direction> directions(2 * fields.size());
  PointCounter counter(options);
  const auto follow = [&](std::size_t i, Source source) {
    FieldScan one(name, setup, *fields[i / 2], runner, options, source);
    directions[i].limit = one.follow(i % 2 != 0, [&] {
      if (source == Source::Run) counter.count();
    });
    directions[i].done = !one.stopped();
    directions[i].rows = std::move(one).rows();
  };
  scan.complete = share_points(directions.size(), options, follow,
                               [&](std::size_t i) { return directions[i].done; });
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const Field& field = *fields[f];
    scan.fields.push_back(
        {&field, number_of(field, setup), directions[2 * f].limit, directions[2 * f + 1].limit});
    for (const std::size_t i : {2 * f, 2 * f + 1}) {
      const std::vector<StabilityRow>& rows = directions[i].rows;
      scan.rows.insert(scan.rows.end(), rows.begin(), rows.end());
    }
  }
  return scan;
}

}  // namespace plastica::sweeps::stability
