#include "sweeps/stability/point_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "plastica/report/format.hpp"
#include "plastica/run/simulate.hpp"
#include "sweeps/advise/discretization.hpp"
#include "sweeps/advise/grading.hpp"
#include "sweeps/run/case_warnings.hpp"
#include "sweeps/run/limited_run.hpp"
#include "sweeps/stability/point_journal.hpp"

namespace plastica::sweeps::stability {
namespace {

using PointClock = std::chrono::steady_clock;

/// A run that takes so many times its estimate is stopped.
constexpr double kTimesEstimate = 20.0;

/// Factors on the sizes of the finer run's axes. In N and 2 N segments a load and a probe may stand
/// at the same part of a segment: the two runs agree then, however far both are off.
constexpr double kOfSegments = 0.25;
constexpr double kOfOthers = 0.5;

/// The same scene, finer in every axis; none where it is as fine as can be.
/// @param of_segments  factor on the size of the segments
std::optional<Setup> finer(const Setup& setup, double of_segments = kOfSegments) {
  const std::vector<FinenessAxis> axes = fineness_axes(setup);
  const Setting own = own_setting(setup, axes);
  Setting fine;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const bool segments = axes[k].field->path == "beam.segments";
    fine.push_back(axes[k].scaled(own[k], segments ? of_segments : kOfOthers));
  }
  if (fine == own) return std::nullopt;
  Setup made = setup_at(setup, axes, fine);
  made.solver.time_step = std::min(made.solver.time_step, kOfOthers * resolving_step(setup));
  const double parts = made.scene.beam.segments / double(setup.scene.beam.segments);
  made.scene.beam = with_divided_segments(setup.scene, static_cast<int>(parts)).beam;
  return made;
}

/// A limit load is an answer of a user's scene: only what every response must keep is known.
Expectation nothing_known() {
  Expectation expected;
  expected.may_reverse = true;
  return expected;
}

}  // namespace

PointRunner::PointRunner(const Setup& setup, const SceneScanOptions& options)
    : setup_(setup), options_(options), watched_(watched_probes(setup, {}).watched) {
  fineness_axes(setup);  // refuses a coupon
  own_work_ = work(setup);
}

double PointRunner::work(const Setup& setup) const {
  return setup.scene.beam.segments * planned_steps(setup);
}

BatchRow PointRunner::simulated(const Setup& setup, double& steps) const {
  // Adaptive steps have no estimate of their own.
  const bool adaptive = setup.solver.step_error > 0.0;
  const RunLimit limit{.steps = kTimesEstimate * planned_steps(setup) * (adaptive ? 100.0 : 10.0)};
  BatchRow row = run_limited(setup, limit, options_.stop).row;
  steps = row.response.counters.steps;
  return row;
}

bool PointRunner::is_own(const Outcome& outcome) const {
  const auto same = [](const OneNumber& a, const OneNumber& b) {
    return a.name == b.name && a.value == b.value;
  };
  return outcome.status == own_.status && outcome.time == own_.time &&
         outcome.history == own_.history && outcome.segments == own_.segments &&
         outcome.break_place == own_.break_place &&
         std::equal(outcome.numbers.begin(), outcome.numbers.end(), own_.numbers.begin(),
                    own_.numbers.end(), same);
}

void PointRunner::compare_with_finer(const Setup& setup, const Outcome& outcome,
                                     JudgedRun& run) const {
  const std::optional<Setup> fine = finer(setup);
  if (!fine) return;
  double steps = 0.0;
  const Outcome other = outcome_of(simulated(*fine, steps), watched_);
  const Deviation off = deviation(outcome, other, watched_);
  run.compared = true;
  run.deviation = off.largest;
  run.quantity = off.quantity;
  const bool of_limit =
      off.largest <= options_.within && is_further_off_limit(setup, *fine, outcome, other, run);
  if (run.deviation <= options_.within) return;
  run.verdict.validity = Validity::Inaccurate;
  if (!usable(other.status)) {
    run.verdict.reason = "a finer run is " + std::string(name_of(other.status));
  } else if (!off.reason.empty()) {
    run.verdict.reason = off.reason;
  } else {
    run.verdict.reason = run.quantity + " is off " +
                         (of_limit ? "the limit of finer runs" : "a finer run") + " by " +
                         report::significant(100.0 * run.deviation, 3) + " %";
  }
}

bool PointRunner::is_further_off_limit(const Setup& setup, const Setup& fine,
                                       const Outcome& outcome, const Outcome& of_fine,
                                       JudgedRun& run) const {
  if (!has_first_order_errors(setup)) return false;
  const std::optional<Setup> between = finer(setup, kOfOthers);
  const double own = 1.0 / setup.scene.beam.segments;
  const double middle = between ? 1.0 / between->scene.beam.segments : own;
  const double finest = 1.0 / fine.scene.beam.segments;
  if (middle == own || middle == finest) return false;
  double steps = 0.0;
  const Outcome of_middle = outcome_of(simulated(*between, steps), watched_);
  const Deviation coarse = deviation(outcome, of_middle, watched_);
  const SignedDeviation both = off_limit_of_two_orders({finest, middle, own}, coarse,
                                                       deviation(of_middle, of_fine, watched_));
  if (std::abs(both.value) <= run.deviation) return false;
  run.deviation = std::abs(both.value);
  run.quantity = both.quantity;
  return true;
}

JudgedRun PointRunner::judged(const Setup& setup, Outcome& outcome, bool warned) const {
  const auto begin = PointClock::now();
  JudgedRun run;
  try {
    double steps = 0.0;
    const BatchRow row = simulated(setup, steps);
    outcome = outcome_of(row, watched_);
    run.energy_balance_error = row.response.energy_balance_error;
    run.segment_steps = steps * setup.scene.beam.segments;
    run.level = row.level;
    run.verdict = judge(setup, row.response, nothing_known());
    const bool limit = run.verdict.validity == Validity::Failed && usable(outcome.status);
    if (limit) run.verdict = {};  // of an elastic beam that snaps: an answer, if it converges
    if (!row.reason.empty()) run.verdict.reason = row.reason;
    if (warned) run.warnings = warnings_of_run(setup, row.response);
    if (run.verdict.validity == Validity::Valid) compare_with_finer(setup, outcome, run);
  } catch (const InputError& error) {
    outcome.status = Status::Rejected;
    run.verdict = {Validity::Failed, error.what()};
  }
  run.status = outcome.status;
  run.seconds = std::chrono::duration<double>(PointClock::now() - begin).count();
  return run;
}

JudgedRun PointRunner::run_own() {
  prepare(setup_.scene, setup_.solver);
  return judged(setup_, own_, true);
}

std::optional<JudgedRun> PointRunner::run(const Setup& setup, Source source) const {
  const bool runs = source == Source::Run;
  if (runs && is_raised(options_.stop)) return std::nullopt;
  std::optional<JudgedRun> known;
  if (options_.journal != nullptr) known = options_.journal->find(setup);
  if (known || !runs) return known;
  Outcome outcome;
  JudgedRun run = judged(setup, outcome, false);
  if (is_raised(options_.stop)) return std::nullopt;
  run.as_own = is_own(outcome);
  if (options_.journal != nullptr) options_.journal->keep(setup, run);
  return run;
}

}  // namespace plastica::sweeps::stability
