#include "sweeps/advise/advice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "plastica/model/scene.hpp"
#include "sweeps/advise/adviser.hpp"
#include "sweeps/advise/graded_candidate.hpp"
#include "sweeps/advise/grading.hpp"

namespace plastica::sweeps {
namespace {

/// For a budget: the error that the first search asks for, how often others are asked for, what of
/// the time they aim at, and how much of the time, or of an error that is too dear, is good enough.
constexpr double kLoosest = 0.5;
constexpr int kBudgetSearches = 6;
constexpr double kAimedTime = 0.85;
constexpr double kGoodUse = 1.3;
/// By how much the error may fall from one search to the next.
constexpr double kLargestFall = 30.0;
/// A setting is not run if it is expected to take so many times the budget.
constexpr double kLikelyTooDear = 2.0;
/// An axis that adds less than this part says nothing of the cost.
constexpr double kOfNoWeight = 0.02;

/// What an advice is about, with the run that it was compared with.
struct Found {
  Candidate candidate{};
  std::optional<Trial> finest{};
  AdviceEnd end = AdviceEnd::Found;
  std::optional<AdviceEnd> cut_short{};  ///< what ended the search for a better one
};

Found found_by(const Adviser& adviser) {
  if (adviser.best()) return {*adviser.best(), adviser.finest(), AdviceEnd::Found, {}};
  return {adviser.last(), adviser.finest(), adviser.end(), {}};
}

/// The error that costs so many times as much as a candidate, by its orders.
double error_for(const Candidate& candidate, double times) {
  double inverse_orders = 0.0;
  for (const AxisError& e : candidate.errors) {
    if (e.error > kOfNoWeight * candidate.numbers) inverse_orders += 1.0 / e.order;
  }
  return candidate.promised * std::pow(times, -1.0 / std::max(inverse_orders, 0.5));
}

/// Whether a search ended because runs or work were used up.
bool is_used_up(AdviceEnd end) {
  return end == AdviceEnd::TooManyRuns || end == AdviceEnd::TooMuchWork;
}

/// The setting of the scene's file, if it takes no more time than the budget and is more accurate
/// than what was found: so that none is advised that is worse.
void look_at_own(AdviceRuns& runs, double budget, Adviser& adviser, Found& fits) {
  const Trial own = runs.own();
  const double foreseen = runs.expected_seconds(fits.candidate.trial) * runs.foreseen_cost({own}) /
                          runs.cost(fits.candidate.trial);
  if (own == fits.candidate.trial || foreseen > kLikelyTooDear * budget) return;
  const auto note_end = [&](AdviceEnd end) {
    if (end == AdviceEnd::Interrupted) fits.end = end;
    if (is_used_up(end)) fits.cut_short = end;
  };
  if (!runs.run_all({own})) return note_end(runs.end());
  if (!usable(runs.outcome(own).status) || runs.expected_seconds(own) > budget) return;
  adviser.look_at(fits.candidate.promised, own);
  Found found = found_by(adviser);
  if (found.end != AdviceEnd::Found) return note_end(found.end);
  const bool better = found.candidate.promised < fits.candidate.promised &&
                      runs.expected_seconds(found.candidate.trial) <= budget;
  if (better) fits = std::move(found);
}

/// Finds the most accurate of those that take no more time than a budget [s].
Found found_for_budget(AdviceRuns& runs, double budget) {
  Adviser adviser(runs);
  adviser.search(kLoosest);
  Found fits = found_by(adviser);
  if (fits.end != AdviceEnd::Found) return fits;
  if (runs.expected_seconds(fits.candidate.trial) > budget) {
    fits.end = AdviceEnd::TooDear;
    return fits;
  }
  look_at_own(runs, budget, adviser, fits);
  if (fits.end != AdviceEnd::Found || fits.cut_short) return fits;
  double too_small = 0.0;  // an error that costs too much
  for (int k = 0; k < kBudgetSearches; ++k) {
    const double promised = fits.candidate.promised;
    const double left = budget / runs.expected_seconds(fits.candidate.trial);
    if (left < kGoodUse || promised < kGoodUse * too_small) break;
    // Between what fits and what does not.
    const double within = std::max({error_for(fits.candidate, kAimedTime * left),
                                    std::sqrt(too_small * promised), promised / kLargestFall});
    adviser.search(within, fits.candidate.trial);
    Found next = found_by(adviser);
    if (next.end == AdviceEnd::Interrupted) return next;
    if (is_used_up(next.end)) {
      fits.cut_short = next.end;
      return fits;
    }
    const bool better = next.end == AdviceEnd::Found && next.candidate.promised < promised &&
                        runs.expected_seconds(next.candidate.trial) <= budget;
    if (better) {
      fits = std::move(next);
    } else {
      too_small = within;
    }
  }
  return fits;
}

}  // namespace

Advice advise(const Setup& setup, const AdviceOptions& options) {
  check_scene(setup.scene, setup.solver);
  AdviceRuns runs(setup, options);
  Found found;
  if (options.budget > 0.0) {
    found = found_for_budget(runs, options.budget);
  } else {
    Adviser adviser(runs);
    adviser.search(options.within);
    found = found_by(adviser);
  }
  if (found.end == AdviceEnd::Found && !(options.budget > 0.0)) {
    if (auto graded = with_graded_segments(runs, found.candidate, options.within)) {
      found.candidate = std::move(*graded);
    }
  }
  const double within = options.budget > 0.0 ? found.candidate.promised : options.within;
  Advice advice = filled_advice(runs, found.candidate, found.finest, within);
  advice.end = found.end;
  advice.cut_short = found.cut_short;
  const Trial& trial = found.candidate.trial;
  if (found.end != AdviceEnd::Interrupted && runs.has(trial)) {
    advice.warnings = runs.outcome(trial).warnings;
  }
  return advice;
}

Setup advised_setup(const Setup& setup, const Advice& advice) {
  Setup advised =
      setup_at(setup_with(setup, advice.word_axes, advice.words), advice.axes, advice.setting);
  advised.scene.beam.segment_fractions = advice.fractions;
  return advised;
}

namespace {

/// Whether a plane has shown to be as good as space: finer numbers do not take a beam out of it.
bool is_same_in_space(const Advice& advice, std::size_t w) {
  return advice.word_axes[w].field().path == "solver.level" && !advice.word_budget.empty() &&
         advice.word_budget[w].error <= kSameWord;
}

}  // namespace

Setup finer_setup(const Setup& setup, const Advice& advice, double factor) {
  Setting setting = advice.setting;
  for (std::size_t k = 0; k < setting.size(); ++k) {
    setting[k] = advice.axes[k].scaled(setting[k], factor);
  }
  setting = taken_setting(setup, advice.axes, std::move(setting));
  Words words = advice.words;
  for (std::size_t w = 0; w < words.size(); ++w) {
    const WordAxis& axis = advice.word_axes[w];
    if (axis.kind != WordKind::Model || is_same_in_space(advice, w)) continue;
    words[w] = axis.richest;
  }
  Setup richest = setup_with(setup, advice.word_axes, words);
  // A scheme that cannot have all of them gives way to one that can.
  if (!is_accepted(richest)) richest.solver.scheme = Scheme::LinearlyImplicitMidpoint;
  Setup finer = setup_at(richest, advice.axes, setting);
  finer.scene.beam = with_divided_segments(advised_setup(setup, advice).scene,
                                           static_cast<int>(std::ceil(1.0 / factor - 1e-9)))
                         .beam;
  return finer;
}

}  // namespace plastica::sweeps
