#include "sweeps/check/run_check.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "sweeps/run/sweep_run.hpp"

namespace plastica::sweeps {
namespace {

using CheckClock = std::chrono::steady_clock;

double seconds_of(CheckClock::time_point begin) {
  return std::chrono::duration<double>(CheckClock::now() - begin).count();
}

/// What a check has run, and how long each of it took.
struct CheckRuns {
  std::vector<SweepRecord> sweeps;
  std::vector<double> sweep_seconds;
};

/// @return whether all were run to their ends
bool run_sweeps(const CheckFile& file, const CheckOptions& options, CheckRuns& runs) {
  std::size_t before = 0;
  for (const Sweep& timed : file.sweeps) {
    const auto begin = CheckClock::now();
    Sweep sweep = timed;
    sweep.timed_runs = 0;  // no claim is about time
    SweepRunOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    SweepRun run(sweep, std::move(how));
    run.on_progress([&](const SweepProgress& progress) {
      if (options.progress) options.progress(before + progress.done);
    });
    std::vector<CaseResult> results = run.run();
    if (!run.complete()) return false;
    before += results.size();
    runs.sweeps.push_back(make_record(sweep, run.cases(), run.ids(), std::move(results)));
    runs.sweep_seconds.push_back(seconds_of(begin));
  }
  return true;
}

/// How many claims are about the same as one.
double sharers(const CheckFile& file, const Claim& claim) {
  return static_cast<double>(
      std::count_if(file.claims.begin(), file.claims.end(), [&](const Claim& other) {
        return !other.scan && other.sweep == claim.sweep;
      }));
}

}  // namespace

std::size_t cases_of(const CheckFile& file) {
  std::size_t cases = 0;
  for (const Sweep& sweep : file.sweeps) cases += CaseTable(sweep).size();
  return cases;
}

std::vector<ClaimVerdict> run_check(const CheckFile& file, const CheckOptions& options) {
  CheckRuns runs;
  if (!run_sweeps(file, options, runs)) return {};
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : file.claims) {
    if (!claim.scan) {
      verdicts.push_back(judge(claim, runs.sweeps[claim.sweep]));
      verdicts.back().seconds = runs.sweep_seconds[claim.sweep] / sharers(file, claim);
      continue;
    }
    const auto begin = CheckClock::now();
    stability::StabilityOptions how = *claim.scan;
    how.threads = options.threads;
    how.stop = options.stop;
    how.max_seconds = std::numeric_limits<double>::infinity();  // no verdict hangs on the machine
    const auto rows = stability::run_stability(how);
    if (is_raised(options.stop)) return {};
    verdicts.push_back(judge(claim, rows));
    verdicts.back().seconds = seconds_of(begin);
  }
  return verdicts;
}

}  // namespace plastica::sweeps
