#include "sweeps/run/sweep_run.hpp"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "calibrate/search/fit_interrupted.hpp"
#include "plastica/base/machine_memory.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/run/batch.hpp"
#include "plastica/run/response_size.hpp"
#include "sweeps/run/case_warnings.hpp"
#include "sweeps/run/measure.hpp"
#include "sweeps/run/result_bytes.hpp"

namespace plastica::sweeps {
namespace {

std::uint64_t journal_kind() {
  return io::Digest().text("plastica/sweep").integer(kResultVersion).value();
}

/// Whether a case's result says what its run has shown; of others the scene alone is looked at.
bool has_warnings(QuantityKind kind) {
  return is_simulated(kind) || kind == QuantityKind::Fit || kind == QuantityKind::BucklingFactor;
}

/// Timed cases run alone, so that they do not slow each other.
int threads_of(const Sweep& sweep, int wanted) {
  return sweep.timed_runs > 0 && wanted == 0 ? 1 : wanted;
}

}  // namespace

SweepRun::SweepRun(const Sweep& sweep, SweepRunOptions options)
    : sweep_(sweep),
      options_(std::move(options)),
      cases_(sweep),
      ids_(cases_.size()),
      owner_(cases_.size()),
      shared_by_(cases_.size(), 0),
      watched_(cases_.size(), false),
      results_(cases_.size()) {
  if (!options_.journal.path.empty()) {
    journal_.emplace(options_.journal, journal_kind(), "cases");
  }
  parallel_for(cases_.size(), {options_.threads, nullptr},
               [&](std::size_t i, int) { ids_[i] = cases_.id(i); });
  std::unordered_map<std::string_view, std::size_t> first;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    owner_[i] = first.emplace(ids_[i], i).first->second;
    ++shared_by_[owner_[i]];
  }
  for (const std::size_t i : watched_cases(ids_.size())) watched_[owner_[i]] = true;
  deal();
  take_earlier();
  const std::size_t there = options_.earlier.size() + (journal_ ? journal_->found() : 0);
  const bool merged = options_.journal.merged != nullptr;
  if (there > 0 && found_ == 0 && !merged && !options_.rerun_failed && !options_.journal.force) {
    const std::string other = journal_ ? journal_->other_instruction_set() : std::string();
    throw InputError({options_.journal.path, 0}, "", "",
                     "has no case of this sweep, nor has its output: " +
                         (other.empty() ? std::string("name another output")
                                        : "they were run with --isa " + other +
                                              ": go on with that, name another output") +
                         ", or use --force to start afresh");
  }
}

/// Says in the journal what is run, and finds what of it is to be run here.
void SweepRun::deal() {
  own_.assign(ids_.size(), true);
  if (journal_) {
    std::vector<std::string> distinct;
    io::Digest run;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (owner_[i] != i) continue;
      distinct.push_back(ids_[i]);
      run.text(ids_[i]);
    }
    const std::vector<bool> own = journal_->begin(io::hexadecimal(run.value()), distinct);
    std::size_t k = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      own_[i] = owner_[i] == i ? own[k++] : own_[owner_[i]];
    }
  }
  const auto count = std::count(own_.begin(), own_.end(), true);
  progress_.total = static_cast<std::size_t>(count);
}

void SweepRun::take_earlier() {
  // A case that is watched now, and was not when it ran, runs again: sixteen at most.
  const auto wanted = [&](const CaseResult& result, std::size_t i) {
    ++found_;
    if (watched_[i] && !result.warnings && has_warnings(sweep_.quantity.kind)) return false;
    return !options_.rerun_failed || usable(result.status);
  };
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (owner_[i] != i || !own_[i]) continue;
    if (const auto* bytes = journal_ ? journal_->find(ids_[i]) : nullptr) {
      CaseResult result = result_from_bytes(*bytes);
      if (wanted(result, i)) results_[i] = std::move(result);
    }
    if (const auto earlier = options_.earlier.find(ids_[i]);
        !results_[i] && earlier != options_.earlier.end() && wanted(earlier->second, i)) {
      results_[i] = earlier->second;
    }
    if (!results_[i]) continue;
    if (!watched_[i]) results_[i]->warnings.reset();  // as in a run of its own
    resumed_ += shared_by_[i];
  }
}

void SweepRun::take(std::size_t index, CaseResult result) {
  if (journal_) journal_->keep(ids_[index], bytes_of(result));
  const std::lock_guard lock(mutex_);
  count(index, result);
  results_[index] = std::move(result);
  tell();
  if (team() == nullptr) return;
  team()->report({progress_.done - before_.done, progress_.failed - before_.failed, 0});
}

void SweepRun::count(std::size_t index, const CaseResult& result) {
  progress_.done += shared_by_[index];
  if (!usable(result.status)) progress_.failed += shared_by_[index];
}

void SweepRun::tell() const {
  if (!report_) return;
  SweepProgress all = progress_;
  all.done += others_[0];
  all.failed += others_[1];
  report_(all);
}

/// Takes the cases that other processes of a team have kept, in the one that leads.
void SweepRun::gather() {
  if (team() == nullptr || !journal_) return;
  journal_->gather(false);
  if (!leads()) return;
  others_ = {};
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (owner_[i] != i || results_[i]) continue;
    const auto* bytes = journal_->find_gathered(ids_[i]);
    if (bytes == nullptr) continue;
    results_[i] = result_from_bytes(*bytes);
    count(i, *results_[i]);
  }
  tell();
}

/// The largest of them may meet.
void SweepRun::check_memory_of(const std::vector<std::size_t>& missing) const {
  std::vector<std::size_t> bytes(missing.size());
  const std::size_t machine = machine_memory();
  parallel_for(missing.size(), {options_.threads, nullptr}, [&](std::size_t k, int) {
    const Setup setup = cases_.setup(missing[k]);
    check_memory(setup.scene, setup.solver, machine);
    bytes[k] = response_size(setup.scene, setup.solver).needed_bytes();
  });
  check_memory(std::move(bytes), resolved_threads(threads_of(sweep_, options_.threads)), machine);
}

void SweepRun::run_missing(const std::vector<std::size_t>& missing, const NextIndex& next) {
  const int threads = threads_of(sweep_, options_.threads);
  check_memory_of(missing);
  if (is_simulated(sweep_.quantity.kind)) {
    const auto make = [&](std::size_t k) {
      Setup setup = cases_.setup(missing[k]);
      return BatchCase{
          ids_[missing[k]], std::move(setup.scene), setup.solver, {}, sweep_.timed_runs};
    };
    const auto finished = [&](std::size_t k, BatchRow&& row) {
      const std::size_t i = missing[k];
      CaseResult result = result_of(row, sweep_.quantity);
      if (watched_[i]) result.warnings = warnings_of_run(cases_.setup(i), row.response);
      take(i, std::move(result));
    };
    run_batch(missing.size(), make, finished,
              {.threads = threads, .stop = options_.stop, .next = next});
    return;
  }
  parallel_for(missing.size(), {threads, options_.stop, next}, [&](std::size_t k, int) {
    CaseResult result;
    try {
      result = measure(sweep_, cases_.setup(missing[k]), options_.stop);
    } catch (const calibrate::FitInterrupted&) {
      return;
    } catch (const InputError& error) {
      result = rejected(error.what());
    }
    if (!watched_[missing[k]]) {
      result.warnings.reset();
    } else if (!result.warnings && has_warnings(sweep_.quantity.kind)) {
      result.warnings.emplace();  // it was looked at, and failed
    }
    take(missing[k], std::move(result));
  });
}

std::vector<CaseResult> SweepRun::run() {
  progress_.resumed = resumed_;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (owner_[i] != i) continue;
    if (!results_[i]) {
      if (own_[i]) missing.push_back(i);
      continue;
    }
    count(i, *results_[i]);
  }
  before_ = progress_;
  if (team() != nullptr) {
    team()->on_report([this](const Team::Counts& others) {
      const std::lock_guard lock(mutex_);
      others_ = others;
      tell();
    });
  }
  tell();
  share(team(), missing.size(), options_.stop,
        [&](const NextIndex& next) { run_missing(missing, next); });
  gather();
  complete_ = progress_.done == progress_.total;
  if (!complete_ && journal_) journal_->sync();

  std::vector<CaseResult> results(ids_.size());
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (results_[owner_[i]]) results[i] = *results_[owner_[i]];
  }
  return results;
}

void SweepRun::end_shard() {
  if (!complete_ || !journal_) throw std::logic_error("SweepRun::end_shard: it is not complete");
  journal_->end_shard();
}

void SweepRun::finish() {
  if (journal_) journal_->finish();
}

}  // namespace plastica::sweeps
