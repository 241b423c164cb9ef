#include "sweeps/check/run_check.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "plastica/base/parallel_for.hpp"
#include "plastica/run/batch.hpp"
#include "sweeps/check/judge_fits.hpp"
#include "sweeps/run/case_warnings.hpp"
#include "sweeps/run/measure.hpp"
#include "sweeps/run/sweep_run.hpp"

namespace plastica::sweeps {
namespace {

using CheckClock = std::chrono::steady_clock;

double seconds_of(CheckClock::time_point begin) {
  return std::chrono::duration<double>(CheckClock::now() - begin).count();
}

/// The first claim on each scene, and all whose quantities one run of it gives.
std::vector<std::vector<std::size_t>> runs_of(const std::vector<Sweep>& scenes) {
  std::vector<std::vector<std::size_t>> runs;
  std::map<std::string, std::size_t> simulated;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const bool shares = is_simulated(scenes[k].quantity.kind);
    if (shares) {
      const auto [place, is_new] = simulated.emplace(scenes[k].scene.path, runs.size());
      if (!is_new) {
        runs[place->second].push_back(k);
        continue;
      }
    }
    runs.push_back({k});
  }
  return runs;
}

/// All that a check runs, each once, and what came out.
class CheckRuns {
 public:
  CheckRuns(const CheckFile& file, const CheckOptions& options) : file_(file), options_(options) {}

  /// @return whether all were run to their ends
  bool run() { return run_sweeps() && run_scenes() && run_all_fits(); }

  ClaimVerdict verdict(const Claim& claim) const {
    switch (claim.subject) {
      case ClaimSubject::Scene: return judged(claim, scenes_[claim.of], scene_seconds_[claim.of]);
      case ClaimSubject::Fit:
        return timed(judge(claim, fits_[claim.of]), fit_seconds_[claim.of] / sharers(claim));
      case ClaimSubject::Sweep:
      case ClaimSubject::Scan: break;
    }
    return judged(claim, sweeps_[claim.of], sweep_seconds_[claim.of] / sharers(claim));
  }

 private:
  static ClaimVerdict timed(ClaimVerdict verdict, double seconds) {
    verdict.seconds = seconds;
    return verdict;
  }

  static ClaimVerdict judged(const Claim& claim, const SweepRecord& record, double seconds) {
    ClaimVerdict verdict = timed(judge(claim, record), seconds);
    verdict.warnings = record.warnings;
    return verdict;
  }

  /// How many claims are about the same sweep or fits as one.
  double sharers(const Claim& claim) const {
    return static_cast<double>(
        std::count_if(file_.claims.begin(), file_.claims.end(), [&](const Claim& other) {
          return other.subject == claim.subject && other.of == claim.of;
        }));
  }

  void tell(std::size_t done) const {
    if (options_.progress) options_.progress(before_ + done);
  }

  bool run_sweeps() {
    for (const Sweep& with_times : file_.sweeps) {
      const auto begin = CheckClock::now();
      Sweep sweep = with_times;
      sweep.timed_runs = 0;  // no claim is about time
      SweepRunOptions how;
      how.threads = options_.threads;
      how.stop = options_.stop;
      SweepRun run(sweep, std::move(how));
      run.on_progress([&](const SweepProgress& progress) { tell(progress.done); });
      std::vector<CaseResult> results = run.run();
      if (!run.complete()) return false;
      before_ += results.size();
      sweeps_.push_back(make_record(sweep, run.cases(), run.ids(), std::move(results)));
      sweep_seconds_.push_back(seconds_of(begin));
    }
    return true;
  }

  /// One run of a scene, for all quantities that claims ask of it.
  void run_scene(const std::vector<std::size_t>& claims, std::vector<CaseResult>& results) const {
    const Sweep& first = file_.scenes[claims.front()];
    if (!is_simulated(first.quantity.kind)) {
      try {
        results[claims.front()] = measure(first, first.setup, options_.stop);
      } catch (const InputError& error) {
        results[claims.front()] = rejected(error.what());
      }
      return;
    }
    const std::vector<BatchCase> one{{first.scene.path, first.setup.scene, first.setup.solver}};
    const auto rows = run_batch(one, {.threads = 1, .stop = options_.stop});
    const auto warnings = warnings_of_run(first.setup, rows.front().response);
    for (const std::size_t k : claims) {
      results[k] = result_of(rows.front(), file_.scenes[k].quantity);
      results[k].warnings = warnings;
    }
  }

  bool run_scenes() {
    const auto runs = runs_of(file_.scenes);
    std::vector<CaseResult> results(file_.scenes.size());
    scene_seconds_.resize(results.size());
    std::mutex telling;
    std::size_t done = 0;
    parallel_for(runs.size(), {options_.threads, options_.stop}, [&](std::size_t r, int) {
      const auto begin = CheckClock::now();
      run_scene(runs[r], results);
      const double share = seconds_of(begin) / static_cast<double>(runs[r].size());
      for (const std::size_t k : runs[r]) scene_seconds_[k] = share;
      const std::lock_guard lock(telling);
      tell(++done);
    });
    if (is_raised(options_.stop)) return false;
    before_ += runs.size();
    for (std::size_t k = 0; k < results.size(); ++k) {
      const Sweep& scene = file_.scenes[k];
      const CaseTable cases(scene);
      scenes_.push_back(make_record(scene, cases, {cases.id(0)}, {std::move(results[k])}));
    }
    return true;
  }

  bool run_all_fits() {
    for (const FitSubject& subject : file_.fits) {
      const auto begin = CheckClock::now();
      auto found =
          run_fits(subject, options_.threads, options_.stop, [&](std::size_t done) { tell(done); });
      if (!found) return false;
      before_ += subject.fits();
      fits_.push_back(std::move(*found));
      fit_seconds_.push_back(seconds_of(begin));
    }
    return true;
  }

  const CheckFile& file_;
  const CheckOptions& options_;
  std::size_t before_ = 0;  ///< cases of what has been run
  std::vector<SweepRecord> sweeps_;
  std::vector<SweepRecord> scenes_;  ///< of one case each
  std::vector<FittedRecords> fits_;
  std::vector<double> sweep_seconds_;
  std::vector<double> scene_seconds_;  ///< of each claim on one
  std::vector<double> fit_seconds_;
};

}  // namespace

std::size_t cases_of(const CheckFile& file) {
  std::size_t cases = runs_of(file.scenes).size();
  for (const Sweep& sweep : file.sweeps) cases += CaseTable(sweep).size();
  for (const FitSubject& subject : file.fits) cases += subject.fits();
  return cases;
}

std::vector<ClaimVerdict> run_check(const CheckFile& file, const CheckOptions& options) {
  CheckRuns runs(file, options);
  if (!runs.run()) return {};
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : file.claims) {
    if (claim.subject != ClaimSubject::Scan) {
      verdicts.push_back(runs.verdict(claim));
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
