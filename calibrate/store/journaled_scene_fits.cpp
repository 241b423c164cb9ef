#include "calibrate/store/journaled_scene_fits.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "calibrate/fit/scene_laws.hpp"
#include "calibrate/search/search_record.hpp"
#include "calibrate/store/result_bytes.hpp"
#include "calibrate/store/scene_fit_digest.hpp"
#include "plastica/base/check.hpp"
#include "plastica/base/instruction_set.hpp"
#include "plastica/base/parallel_for.hpp"
#include "plastica/base/version.hpp"
#include "plastica/io/digest.hpp"

namespace plastica::calibrate {
namespace {

std::uint64_t scene_journal_kind() {
  return io::Digest()
      .text("plastica/scene-fits")
      .integer(kResultVersion)
      .integer(kSearchRecordVersion)
      .value();
}

/// Who a fit is: its name, and a digest of all that can change the result's bits, the instruction
/// sets that its scenes run with among them.
std::string id_of(const SceneFitCase& one, const SceneFitOptions& options) {
  io::Digest digest;
  digest.text(version()).integer(digest_of(one.targets, options));
  for (const WeightedTarget& weighted : one.targets) {
    digest.text(name_of(resolved(weighted.setup.solver.isa)));
  }
  return one.name + " " + io::hexadecimal(digest.value());
}

/// The id of a finished stage of a fit.
std::string stage_of(const std::string& id, std::string_view name) {
  return id + "/" + std::string(name);
}

/// What each of several laws is told.
SceneFitOptions without_extras(SceneFitOptions options) {
  options.segments_error = false;
  options.intervals = {};
  return options;
}

/// Whether the advised law gets more than the others have.
bool completes_one(const SceneFitOptions& options) {
  const auto& intervals = options.intervals;
  const bool any = options.segments_error || intervals.profile || intervals.bootstrap > 0 ||
                   intervals.specimens > 0;
  return any && !options.laws.empty();
}

/// What is told, if it can be done: what cannot leaves a journal as it is.
JournaledOptions checked(JournaledOptions how, const SceneFitOptions& options) {
  if (how.journal.shard) check_dealt(options);
  return how;
}

}  // namespace

void check_dealt(const SceneFitOptions& options) {
  if (!completes_one(options)) return;
  throw InputError({}, "--shard", "",
                   "cannot tell which law all fits together advise, and that alone gets intervals "
                   "and other numbers of segments: ask for no intervals, and set segments_error = "
                   "false");
}

JournaledSceneFits::JournaledSceneFits(std::span<const SceneFitCase> cases,
                                       const SceneFitOptions& options, JournaledOptions how,
                                       std::function<void(const SceneFitProgress&)> within)
    : JournaledFits(checked(std::move(how), options), scene_journal_kind(),
                    "fits and stages of fits"),
      cases_(cases),
      options_(options),
      within_(std::move(within)) {
  for (std::size_t of = 0; of < cases.size(); ++of) {
    const SceneFitCase& one = cases[of];
    if (options.laws.empty()) {
      fits_.push_back({of, std::nullopt});
      ids_.push_back(id_of(one, options));
    }
    for (const Law law : options.laws) {
      fits_.push_back({of, law});
      SceneFitCase named = one;
      named.name = fmt::format("{}:{}", one.name, name_of(law));
      ids_.push_back(id_of(named, without_extras(options)));
      // The word is part of `run_id`, which outputs of older versions have.
      if (completes_one(options)) complete_ids_.push_back(id_of(named, options) + " whole");
    }
  }
  deal(make_run_id(), std::max<std::size_t>(1, options.laws.size()));
  resume();
  for (const std::vector<std::string>* all : {&ids_, &complete_ids_}) {
    for (const std::string& id : *all) {
      const std::size_t stages = journal_.found_under(stage_of(id, ""));
      const bool ended = journal_.find(id) != nullptr;
      if (!ended) stages_ += stages;
      stale_ -= stages + (ended && all == &complete_ids_ ? 1 : 0);
    }
  }
  seconds_.assign(fits_.size(), std::numeric_limits<double>::quiet_NaN());
  stages_kept_.resize(fits_.size());
  completed_.assign(fits_.size(), 0);
}

std::string JournaledSceneFits::make_run_id() const {
  std::vector<std::string> ids = ids_;
  ids.insert(ids.end(), complete_ids_.begin(), complete_ids_.end());
  return run_id_of(std::move(ids));
}

/// Fits one law of a case whose simpler laws have been fitted.
SceneFitResult JournaledSceneFits::fit_law(std::size_t index, bool complete,
                                           SceneFitOptions options) const {
  const Fit& one = fits_[index];
  const std::vector<WeightedTarget>& given = cases_[one.of].targets;
  const std::vector<WeightedTarget> targets = targets_of(*one.law, given);
  options = options_of(*one.law, complete ? options : without_extras(options), given);
  const std::size_t first = first_fit(one.of);
  const auto for_simpler = [&](const auto& each) {
    for (std::size_t k = first; k < index; ++k) {
      const bool fitted = results_[k] && results_[k]->status == FitStatus::Fitted;
      if (fitted && contains(*one.law, *fits_[k].law)) each(*results_[k]);
    }
  };
  for_simpler([&](const SceneFitResult& simpler) { start_from(simpler, options); });
  SceneFitResult result = calibrate::fit(targets, options);
  for_simpler([&](const SceneFitResult& simpler) { compare_with(simpler, targets, result); });
  return result;
}

/// @return nothing if it was stopped
std::optional<SceneFitResult> JournaledSceneFits::fit(std::size_t index, bool complete) {
  const std::string& id = complete ? complete_ids_[index] : ids_[index];
  SceneFitOptions options = options_;
  options.threads = threads_;
  options.hooks = {};
  options.hooks.stop = how_.stop;
  options.hooks.find = [&](const std::string& name) -> const std::vector<std::byte>* {
    const auto kept = stages_kept_[index].find(name);
    if (kept != stages_kept_[index].end()) return &kept->second;
    const std::vector<std::byte>* found = journal_.find(stage_of(id, name));
    return found != nullptr ? found : journal_.find(stage_of(ids_[index], name));
  };
  options.hooks.keep = [&](const std::string& name, std::span<const std::byte> bytes) {
    if (completes_one(options_)) stages_kept_[index][name].assign(bytes.begin(), bytes.end());
    journal_.keep(stage_of(id, name), bytes);
  };
  const bool alone = cases_.size() == 1;
  if (alone) options.hooks.progress = within_;
  try {
    return fits_[index].law ? fit_law(index, complete, std::move(options))
                            : calibrate::fit(cases_[fits_[index].of].targets, options);
  } catch (const FitInterrupted&) {
    return std::nullopt;
  } catch (const InputError& error) {
    if (alone) throw;
    SceneFitResult failed;
    const Material& material = cases_[fits_[index].of].targets.front().setup.scene.material;
    failed.law = fits_[index].law.value_or(law_of(material.hardening, options_.parameters));
    failed.reason = error.what();
    return failed;
  }
}

/// @param complete  the advised law, which is to get what is made of it alone; empty: what is
/// missing
void JournaledSceneFits::fit_side_by_side(const std::vector<std::size_t>& of,
                                          std::optional<Law> complete, const NextIndex& next) {
  const bool several = of.size() > 1;
  threads_ = several ? 1 : how_.threads;
  parallel_for(of.size(), {several ? how_.threads : 1, how_.stop, next}, [&](std::size_t k, int) {
    for (std::size_t i = first_fit(of[k]); i < first_fit(of[k] + 1); ++i) {
      if (complete ? fits_[i].law != complete : results_[i] != nullptr) continue;
      const auto begin = std::chrono::steady_clock::now();
      std::optional<SceneFitResult> result = fit(i, complete.has_value());
      if (!result) return;
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      if (complete) {
        journal_.keep(complete_ids_[i], bytes_of(*result));
        completed_[i] = 1;
      } else {
        seconds_[i] = took.count();
        keep(i, *result);
      }
      results_[i] = std::make_unique<SceneFitResult>(std::move(*result));
    }
  });
}

/// The law that is advised for all cases; if none is, the first.
Law JournaledSceneFits::advised() const {
  std::vector<std::vector<LawFit>> targets(cases_.size());
  for (std::size_t i = 0; i < fits_.size(); ++i) {
    const SceneFitRecord record = record_of(cases_[fits_[i].of], *results_[i]);
    targets[fits_[i].of].push_back(law_fit_of(record));
  }
  const LawComparison laws = compare_laws_over(std::move(targets));
  return laws.advised ? laws.laws[*laws.advised].fit.law : options_.laws.front();
}

/// Makes of the fits of the advised law what is made of them alone.
void JournaledSceneFits::complete_advised() {
  const Law law = advised();
  std::vector<std::size_t> unfinished;
  const auto take_found = [&](std::size_t i) {
    const std::vector<std::byte>* bytes = journal_.find(complete_ids_[i]);
    if (bytes == nullptr) return;
    results_[i] = std::make_unique<SceneFitResult>(result_from_bytes<SceneFitResult>(*bytes));
    completed_[i] = 1;
  };
  for (std::size_t i = 0; i < fits_.size(); ++i) {
    if (fits_[i].law != law) continue;
    take_found(i);
    if (results_[i]->status == FitStatus::Failed) completed_[i] = 1;
    if (completed_[i] == 0) unfinished.push_back(i);
  }
  std::vector<std::size_t> of;
  of.reserve(unfinished.size());
  for (const std::size_t i : unfinished) of.push_back(fits_[i].of);
  share(team(), of.size(), how_.stop,
        [&](const NextIndex& next) { fit_side_by_side(of, law, next); });
  journal_.gather(false);
  for (const std::size_t i : unfinished) {
    if (completed_[i] == 0) take_found(i);
  }
  advised_is_complete_ =
      std::ranges::all_of(unfinished, [&](std::size_t i) { return completed_[i] != 0; });
}

std::vector<SceneFitResult> JournaledSceneFits::run() {
  start_run();
  std::vector<std::size_t> missing;
  for (std::size_t of = 0; of < cases_.size(); ++of) {
    const auto begin = results_.begin() + static_cast<std::ptrdiff_t>(first_fit(of));
    const auto end = results_.begin() + static_cast<std::ptrdiff_t>(first_fit(of + 1));
    if (is_own(first_fit(of)) &&
        !std::all_of(begin, end, [](const auto& r) { return r != nullptr; })) {
      missing.push_back(of);
    }
  }
  share(team(), missing.size(), how_.stop,
        [&](const NextIndex& next) { fit_side_by_side(missing, std::nullopt, next); });
  gather(completes_one(options_));
  if (completes_one(options_) && progress_.done == fits_.size()) complete_advised();
  end_run(progress_.done == progress_.total && (!completes_one(options_) || advised_is_complete_));
  std::vector<SceneFitResult> results;
  for (const auto& result : results_) {
    results.push_back(result ? std::move(*result) : SceneFitResult{});
  }
  return results;
}

}  // namespace plastica::calibrate
