#include "sweeps/advise/fill_advice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace plastica::sweeps {
namespace {

/// The scene as its file has it is run if it is expected to take no more work than so many times
/// that of the advised one.
constexpr double kAffordable = 2.0;

class Filler {
 public:
  Filler(AdviceRuns& runs, const Candidate& candidate, const std::optional<Trial>& finest,
         double within)
      : runs_(runs), candidate_(candidate), finest_(finest), within_(within) {
    for (std::size_t k = 0; k < runs.axes().size(); ++k) {
      if (runs.acts(k, candidate.trial.words)) acting_.push_back(k);
    }
  }

  Advice advice();

 private:
  Setting shown(const Setting& setting) const {
    Setting made;
    for (const std::size_t k : acting_) made.push_back(setting[k]);
    return made;
  }
  TriedSetting tried(const Trial& trial) const;
  bool is_as_fine(const Trial& trial) const;
  TriedSetting own();
  void fill_runs(Advice& advice) const;

  AdviceRuns& runs_;
  const Candidate& candidate_;
  const std::optional<Trial>& finest_;
  double within_;
  std::vector<std::size_t> acting_;  ///< axes of the candidate's words
};

bool Filler::is_as_fine(const Trial& trial) const {
  if (trial.words != finest_->words) return false;
  for (const std::size_t k : acting_) {
    const FinenessAxis& axis = runs_.axes()[k];
    if (axis.size(trial.setting[k]) > axis.size(finest_->setting[k])) return false;
  }
  return true;
}

TriedSetting Filler::tried(const Trial& trial) const {
  const Outcome& of = runs_.outcome(trial);
  TriedSetting one{.setting = shown(trial.setting),
                   .words = trial.words,
                   .fractions = trial.fractions,
                   .work = of.work,
                   .cost = runs_.cost(trial),
                   .seconds = of.seconds};
  if (!finest_) {
    one.error = std::numeric_limits<double>::infinity();
    one.reason = "no setting was fine enough to compare with";
  } else if (is_as_fine(trial)) {
    one.error = std::numeric_limits<double>::infinity();
    one.reason = "it is as fine as the run that verifies";
  } else {
    const Deviation off = runs_.off(trial, *finest_);
    one.error = off.largest + candidate_.of_finest + candidate_.of_words;
    one.reason = off.reason;
  }
  return one;
}

TriedSetting Filler::own() {
  const Trial trial = runs_.own();
  TriedSetting one{.setting = shown(trial.setting),
                   .words = trial.words,
                   .error = std::numeric_limits<double>::infinity()};
  if (!runs_.has(trial) && runs_.has(candidate_.trial)) {
    const double times = runs_.foreseen_cost({trial}) / runs_.cost(candidate_.trial);
    if (times > kAffordable) {
      one.reason = fmt::format("not run, it takes about {:.2g} times as long", times);
      return one;
    }
    if (!runs_.run_all({trial})) {
      one.reason = "not run, runs or work were used up";
      return one;
    }
  }
  return runs_.has(trial) ? tried(trial) : one;
}

void Filler::fill_runs(Advice& advice) const {
  for (const auto& [trial, of] : runs_.outcomes()) {
    advice.total_work += of.work;
    advice.total_seconds += of.seconds;
    if (!usable(of.status)) continue;
    advice.tried.push_back(tried(trial));
    const TriedSetting& one = advice.tried.back();
    const bool misses =
        finest_ && one.error > within_ && one.cost < advice.cost && trial != *finest_;
    const bool dearer = !advice.next_cheaper || one.cost > advice.next_cheaper->cost;
    if (misses && dearer) advice.next_cheaper = one;
  }
}

Advice Filler::advice() {
  Advice advice;
  advice.word_axes = runs_.word_axes();
  advice.words = candidate_.trial.words;
  advice.word_budget = candidate_.lines;
  for (const std::size_t k : acting_) {
    advice.axes.push_back(runs_.axes()[k]);
    if (candidate_.errors.empty()) continue;
    const AxisError& e = candidate_.errors[k];
    advice.budget.push_back({e.error, e.order, e.seen});
  }
  advice.setting = shown(candidate_.trial.setting);
  advice.promised = candidate_.promised;
  advice.verified = candidate_.verified + candidate_.of_words;
  advice.words_settled = candidate_.words_settled;
  advice.of_words = candidate_.of_words;
  advice.worst = candidate_.worst;
  advice.reason = candidate_.reason;
  advice.left_out = runs_.probes().left_out;
  advice.fractions = candidate_.trial.fractions;
  if (candidate_.even) advice.even = tried(*candidate_.even);
  if (runs_.has(candidate_.trial)) {
    const Outcome& of = runs_.outcome(candidate_.trial);
    advice.work = of.work;
    advice.seconds = of.seconds;
    advice.cost = runs_.cost(candidate_.trial);
    if (of.work > 0) advice.expected_seconds = runs_.expected_seconds(candidate_.trial);
  }
  advice.own = own();
  advice.runs = runs_.runs();
  fill_runs(advice);
  return advice;
}

}  // namespace

double promise(const Candidate& candidate, double words) {
  const double most = std::max(candidate.numbers + words,
                               candidate.verified + candidate.of_finest + candidate.of_words);
  return most * (1.0 + most);
}

Advice filled_advice(AdviceRuns& runs, const Candidate& candidate,
                     const std::optional<Trial>& finest, double within) {
  return Filler(runs, candidate, finest, within).advice();
}

}  // namespace plastica::sweeps
