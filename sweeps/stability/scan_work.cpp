#include "sweeps/stability/scan_work.hpp"

#include <utility>
#include <variant>

#include "plastica/base/parallel_for.hpp"
#include "plastica/report/format.hpp"
#include "sweeps/stability/point_journal.hpp"

namespace plastica::sweeps::stability {

double number_of(const Field& field, const Setup& setup) {
  const FieldValue value = field.get(setup);
  const auto* number = std::get_if<double>(&value);
  return number == nullptr ? std::nan("") : *number;
}

double whole_value(const Field& field, double value) {
  return field.kind == FieldKind::Integer ? std::round(value) : value;
}

ScannedValue scanned(const Field& field, double value) {
  return {std::string(field.path), std::string(si_unit(field.dimension)), value};
}

JudgedRun refused(const InputError& error) {
  JudgedRun run;
  run.status = Status::Rejected;
  run.verdict = {Validity::Failed, error.what()};
  return run;
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
  row.status = run.status;
  row.energy_balance_error = run.energy_balance_error;
  row.segment_steps = run.segment_steps;
  row.seconds = run.seconds;
  return row;
}

Team* team_of(const SceneScanOptions& options) {
  return options.journal == nullptr ? nullptr : options.journal->team();
}

PointCounter::PointCounter(const SceneScanOptions& options) : options_(options) {
  Team* team = team_of(options);
  if (team == nullptr) return;
  team->on_report([this](const Team::Counts& others) {
    const std::lock_guard lock(mutex_);
    others_ = others[0];
    tell();
  });
}

void PointCounter::count() {
  const std::lock_guard lock(mutex_);
  ++points_;
  tell();
  if (Team* team = team_of(options_)) team->report({points_, 0, 0});
}

void PointCounter::tell() const {
  if (options_.progress) options_.progress(points_ + others_);
}

bool share_points(std::size_t count, const SceneScanOptions& options,
                  const std::function<void(std::size_t, Source)>& take,
                  const std::function<bool(std::size_t)>& is_done) {
  const bool stopped = share(team_of(options), count, options.stop, [&](const NextIndex& next) {
    parallel_for(count, {options.threads, options.stop, next},
                 [&](std::size_t i, int) { take(i, Source::Run); });
  });
  if (options.journal != nullptr) options.journal->gather();
  bool complete = !stopped && !is_raised(options.stop);
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_done(i) && team_of(options) != nullptr) take(i, Source::Recall);
    complete = complete && is_done(i);
  }
  return complete;
}

}  // namespace plastica::sweeps::stability
