#include "sweeps/advise/settled_words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace plastica::sweeps {
namespace {

constexpr double kSettledPart = 0.2;
constexpr double kSettledOfAllowed = 0.05;
/// A number is refined if it is finer by this factor; one that adds less than this part of the
/// error of all does not matter.
constexpr double kRefinedBy = 1.3;
constexpr double kMinor = 0.1;

}  // namespace

bool measure_settled(AdviceRuns& runs, const WordChooser& words, const Candidate& candidate,
                     double within, double worth, SettledWords& found) {
  found = {};
  const Trial& trial = candidate.trial;
  const Trial before =
      runs.taken({trial.words, words.decided_at().setting, words.decided_at().fractions});
  std::vector<Trial> beside;  // finer than `before` in what was not refined since
  double ratio = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < runs.axes().size(); ++k) {
    if (!(candidate.errors[k].error >= kMinor * candidate.numbers)) continue;
    const FinenessAxis& axis = runs.axes()[k];
    const double refined = axis.size(before.setting[k]) / axis.size(trial.setting[k]);
    if (refined >= kRefinedBy) {
      ratio = std::min(ratio, refined);
    } else {
      std::vector<double> factors(runs.axes().size(), 1.0);
      factors[k] = 0.5;
      beside.push_back(runs.scaled(before, factors));
    }
  }
  std::vector<Trial> all{trial, before};
  all.insert(all.end(), beside.begin(), beside.end());
  for (std::size_t i = 0, poor = all.size(); i < poor; ++i) all.push_back(words.enriched(all[i]));
  if (runs.foreseen_cost(all) > worth) return true;
  if (!runs.run_all(all)) return false;
  const auto left_out = [&](const Trial& one) {
    return runs.off(one, words.enriched(one), "richer").largest;
  };
  const double now = left_out(trial);
  const double then = left_out(before);
  double change = std::abs(now - then);
  double to_come = change / (ratio - 1.0);
  for (const Trial& one : beside) {
    const double along = std::abs(left_out(one) - then);
    change += along;
    to_come += along;
  }
  found.error = now + to_come;
  found.are_so = change <= std::max(kSettledPart * now, kSettledOfAllowed * within) &&
                 candidate.numbers + found.error <= within;
  return true;
}

}  // namespace plastica::sweeps
