#include "sweeps/advise/advice_runs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "plastica/base/median.hpp"
#include "plastica/base/parallel_for.hpp"
#include "sweeps/advise/grading.hpp"
#include "sweeps/run/case_warnings.hpp"

namespace plastica::sweeps {
namespace {

/// Where more than 1 % is allowed fewer than `kRichFibres` do, at least so many. Forty are 0.002 %
/// off (docs/accuracy.md), of second order.
constexpr double kFewestRichFibres = 16.0;
/// A run is stopped where it costs so many times what was foreseen. No run of an advice on the
/// shipped scenes for 0.3 % costs more than 42 times that.
constexpr double kTimesForeseen = 200.0;

/// The scene with all that advice may choose in it, so that it has every axis of numbers.
Setup richest_of(const Setup& setup, const std::vector<WordAxis>& axes) {
  Words words;
  for (const WordAxis& axis : axes) words.push_back(axis.richest);
  return setup_with(setup, axes, words);
}

}  // namespace

CostLimit cost_limit(double left, double foreseen) {
  const double most = kTimesForeseen * foreseen;
  return most < left ? CostLimit{most, false} : CostLimit{left, true};
}

AdviceRuns::AdviceRuns(const Setup& setup, const AdviceOptions& options)
    : setup_(setup),
      options_(options),
      word_axes_(plastica::sweeps::word_axes(setup)),
      axes_(fineness_axes(richest_of(setup, word_axes_))),
      own_setting_(own_setting(setup, axes_)),
      idle_setting_(own_setting_),
      probes_(watched_probes(setup, options.probes)) {
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (axes_[k].field->path != "solver.fibres") continue;
    // For a budget the error that is asked for is not known yet.
    const double allowed = options.budget > 0.0 ? 0.01 : std::max(options.within, 0.01);
    const double fibres = std::ceil(kRichFibres * std::sqrt(0.01 / allowed));
    idle_setting_[k] = std::max(fibres, kFewestRichFibres);
    axes_[k].finer_at_least = idle_setting_[k];
  }
}

Setup AdviceRuns::setup_of(const Trial& trial) const {
  Setup at = setup_at(setup_with(setup_, word_axes_, trial.words), axes_, trial.setting);
  at.scene.beam.segment_fractions = trial.fractions;
  return at;
}

bool AdviceRuns::acts(std::size_t axis, const Words& words) const {
  const auto there = fineness_axes(setup_with(setup_, word_axes_, words));
  return std::ranges::any_of(
      there, [&](const FinenessAxis& one) { return one.field == axes_[axis].field; });
}

Trial AdviceRuns::taken(Trial trial) const {
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (!acts(k, trial.words)) trial.setting[k] = idle_setting_[k];
  }
  trial.setting = taken_setting(setup_, axes_, std::move(trial.setting));
  return trial;
}

Trial AdviceRuns::with_ends_at_probes(Trial trial) const {
  trial.fractions.clear();
  Scene scene = setup_of(trial).scene;
  const int segments = scene.beam.segments;
  for (int more = 0; 4 * more <= segments; ++more) {
    scene.beam.segments = segments + more;
    if (!ends_at_probes(scene)) continue;
    trial.setting[0] = scene.beam.segments;
    return trial;
  }
  Trial divided = trial;
  divided.fractions = fractions_that_end_at_probes(setup_of(trial).scene);
  return is_accepted(setup_of(divided)) ? divided : trial;
}

Trial AdviceRuns::own() const { return taken({own_words(word_axes_), own_setting_}); }

Trial AdviceRuns::scaled(const Trial& trial, const std::vector<double>& factors) const {
  Trial made = trial;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (acts(k, trial.words)) made.setting[k] = axes_[k].scaled(trial.setting[k], factors[k]);
  }
  made = taken(std::move(made));
  const double parts = std::round(1.0 / factors[0]);
  const bool divides =
      std::abs(parts * factors[0] - 1.0) < 1e-9 && parts * trial.setting[0] <= axes_[0].finest;
  if (!divides) return with_ends_at_probes(std::move(made));
  Scene divided = with_divided_segments(setup_of(trial).scene, static_cast<int>(parts));
  made.setting[0] = divided.beam.segments;
  made.fractions = std::move(divided.beam.segment_fractions);
  return made;
}

bool AdviceRuns::run_all(std::vector<Trial> trials) {
  std::sort(trials.begin(), trials.end());
  trials.erase(std::unique(trials.begin(), trials.end()), trials.end());
  std::erase_if(trials, [&](const Trial& trial) { return has(trial); });
  if (runs_ + static_cast<int>(trials.size()) > options_.max_runs) {
    end_ = AdviceEnd::TooManyRuns;
    return false;
  }
  if (cost_ + foreseen_cost(trials) > options_.max_work) {
    end_ = AdviceEnd::TooMuchWork;
    return false;
  }
  std::vector<CostLimit> limits;
  limits.reserve(trials.size());
  for (const Trial& trial : trials) limits.push_back(limit_of(trial, trials));
  std::vector<LimitedRun> made(trials.size());
  std::vector<std::vector<std::string>> warnings(trials.size());
  std::mutex telling;
  int done = 0;
  parallel_for(trials.size(), {options_.threads, options_.stop}, [&](std::size_t i, int) {
    made[i] = run(trials[i], limits[i]);
    if (usable(made[i].row.response.status)) {
      warnings[i] = warnings_of_run(setup_of(trials[i]), made[i].row.response);
    }
    if (!options_.progress || is_raised(options_.stop)) return;
    const std::lock_guard lock(telling);
    options_.progress(runs_ + ++done);
  });
  if (is_raised(options_.stop)) {
    end_ = AdviceEnd::Interrupted;
    return false;
  }
  bool used_up = false;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    Outcome outcome = outcome_of(made[i].row, probes_.watched);
    outcome.warnings = std::move(warnings[i]);
    outcomes_.emplace(trials[i], std::move(outcome));
    cost_ += cost(trials[i]);
    used_up = used_up || (made[i].stopped && limits[i].of_all_work);
  }
  runs_ += static_cast<int>(trials.size());
  if (used_up) end_ = AdviceEnd::TooMuchWork;
  return !used_up;
}

CostLimit AdviceRuns::limit_of(const Trial& trial, const std::vector<Trial>& together) const {
  const double left = options_.max_work - cost_;
  const double foreseen = foreseen_cost({trial});
  // Nothing is foreseen of the first ones: they have equal parts.
  if (!(foreseen > 0.0)) return {left / static_cast<double>(together.size()), true};
  const Setup at = setup_of(trial);
  const double planned = planned_steps(at) * at.scene.beam.segments * kernel_cost(at);
  return cost_limit(left - (foreseen_cost(together) - foreseen), std::max(foreseen, planned));
}

LimitedRun AdviceRuns::run(const Trial& trial, const CostLimit& limit) const {
  LimitedRun run;
  try {
    const Setup at = setup_of(trial);
    const double of_iteration = at.scene.beam.segments * kernel_cost(at);
    run = run_limited(at, {.iterations = limit.cost / of_iteration}, options_.stop);
  } catch (const InputError& error) {
    run.row.response.status = Status::Rejected;
    run.row.reason = error.what();
  } catch (const std::exception& error) {
    run.row.reason = error.what();  // out of memory, or a defect: the others go on
  }
  return run;
}

bool AdviceRuns::affords(const Trial& trial) const {
  if (has(trial)) return true;
  return runs_ < options_.max_runs && cost_ + foreseen_cost({trial}) <= options_.max_work;
}

bool AdviceRuns::is_as_fine_and_rich(const Trial& trial, const Trial& as) const {
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    const bool coarser = axes_[k].size(trial.setting[k]) > axes_[k].size(as.setting[k]);
    if (coarser && acts(k, as.words)) return false;
  }
  for (std::size_t w = 0; w < word_axes_.size(); ++w) {
    if (word_axes_[w].kind == WordKind::Model && trial.words[w] < as.words[w]) return false;
  }
  return true;
}

std::string AdviceRuns::at_rest_where_finer_moves(const Trial& trial, const Trial& finer) const {
  for (std::size_t p = 0; p < probes_.watched.size(); ++p) {
    const WatchedProbe& probe = probes_.watched[p];
    const auto moves = [&](const Outcome& of) {
      return p < of.history.size() && std::ranges::any_of(of.history[p], [&](double value) {
               return std::abs(value) > probe.least;
             });
    };
    if (moves(outcome(trial)) || moves(outcome(finer))) continue;
    const bool elsewhere = std::ranges::any_of(outcomes_, [&](const auto& ran) {
      return usable(ran.second.status) && is_as_fine_and_rich(ran.first, trial) &&
             moves(ran.second);
    });
    if (elsewhere) return probe.name;
  }
  return {};
}

double AdviceRuns::cost(const Trial& trial) const {
  return static_cast<double>(outcome(trial).work) * kernel_cost(setup_of(trial));
}

double AdviceRuns::expected_work(const Trial& from, const Trial& to) const {
  double factor = 1.0;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (axes_[k].field->path == "solver.fibres") continue;
    factor *= axes_[k].size(from.setting[k]) / axes_[k].size(to.setting[k]);
  }
  return factor;
}

double AdviceRuns::expected_cost(const Trial& from, const Trial& to) const {
  return expected_work(from, to) * kernel_cost(setup_of(to)) / kernel_cost(setup_of(from));
}

double AdviceRuns::expected_seconds(const Trial& trial) const {
  constexpr double kAbout = 8.0;  // runs whose work differs by no more are alike
  const auto work = static_cast<double>(outcome(trial).work);
  std::vector<double> rates;
  for (const auto& [ran, of] : outcomes_) {
    const double ratio = static_cast<double>(of.work) / work;
    if (ran.words != trial.words || ratio > kAbout || ratio < 1.0 / kAbout) continue;
    rates.push_back(of.seconds / static_cast<double>(of.work));
  }
  return work * median_of(std::move(rates));
}

double AdviceRuns::foreseen_cost(const std::vector<Trial>& trials) const {
  double sum = 0.0;
  for (const Trial& trial : trials) {
    if (has(trial)) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [ran, of] : outcomes_) {
      // What failed early says nothing of one that does not.
      if (!is_complete(of.status)) continue;
      least = std::min(least, cost(ran) * expected_cost(ran, trial));
    }
    if (std::isfinite(least)) sum += least;
  }
  return sum;
}

}  // namespace plastica::sweeps
