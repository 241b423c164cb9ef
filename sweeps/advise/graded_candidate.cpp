#include "sweeps/advise/graded_candidate.hpp"

#include <algorithm>
#include <cmath>

#include "sweeps/advise/grading.hpp"

namespace plastica::sweeps {
namespace {

/// Graded segments must cost less than this part of what even ones do: a list of lengths is more to
/// read than a number.
constexpr double kWorthGrading = 0.8;
/// So many numbers of segments are tried.
constexpr int kTries = 3;
constexpr double kAimed = 0.9;  ///< of the allowed error that a number of segments aims at
constexpr double kFewest = 4.0;
/// Of the sum over the axes: what segments must add for their lengths to matter.
constexpr double kWorthLooking = 0.2;

class Grading {
 public:
  Grading(AdviceRuns& runs, const Candidate& even, double within)
      : runs_(runs),
        even_(even),
        within_(within),
        scene_(runs.setup_of(even.trial).scene),
        bent_(runs.outcome(even.trial).bent) {
    for (const WordLine& line : even.lines) words_ += line.error;
  }

  std::optional<Candidate> best() {
    const double own = even_.trial.setting[0];
    if (!(kFewest < kWorthGrading * own)) return std::nullopt;
    const Trial same = graded(own);
    if (same.fractions.empty() || !can_run({same})) return std::nullopt;
    const double off = runs_.off(same, *even_.finest).largest;
    if (!std::isfinite(off)) return std::nullopt;
    // All that is off but by the segments stays as it is.
    const double others = even_.numbers - even_.errors[0].error;
    const double left = std::max(off - others, 0.05 * off) + even_.of_finest;
    double segments = number_for(own, left);
    for (int k = 0; k < kTries && segments < kWorthGrading * own; ++k) {
      std::optional<Candidate> found = candidate(segments);
      if (!found) return std::nullopt;
      if (found->within) {
        const bool cheaper = runs_.cost(found->trial) < kWorthGrading * runs_.cost(even_.trial);
        return cheaper ? found : std::nullopt;
      }
      const double next = number_for(segments, found->promised - others - even_.of_words);
      segments = std::max(next, segments + 1.0);
    }
    return std::nullopt;
  }

 private:
  Trial graded(double segments) const {
    Trial trial = even_.trial;
    trial.setting[0] = segments;
    trial.fractions = graded_fractions(scene_, bent_, static_cast<int>(segments));
    return trial;
  }

  /// How many segments leave what the other axes do not take, of a number and the error it has.
  double number_for(double segments, double error) const {
    const double others = even_.numbers - even_.errors[0].error;
    const double allowed = kAimed * (within_ - words_) - others;
    if (!(allowed > 0.0)) return segments;
    return std::max(std::ceil(segments * std::sqrt(error / allowed)), kFewest);
  }

  bool can_run(const std::vector<Trial>& trials) {
    for (const Trial& trial : trials) {
      if (!is_accepted(runs_.setup_of(trial))) return false;
    }
    return runs_.run_all(trials);
  }

  std::optional<Candidate> candidate(double segments) {
    Candidate made = even_;
    made.even = even_.trial;
    made.trial = graded(segments);
    Trial halved = made.trial;
    halved.setting[0] *= 2.0;
    halved.fractions = divided_evenly(made.trial.fractions, 2);
    if (made.trial.fractions.empty() || !can_run({made.trial, halved})) return std::nullopt;
    AxisError& along = made.errors[0];
    along.change = runs_.off(made.trial, halved).largest;
    along.ratio = 2.0;
    along.order = even_.errors[0].seen && !has_first_order_errors(runs_.setup_of(even_.trial))
                      ? even_.errors[0].order
                      : 1.0;
    along.error = left_of(along.change, along.ratio, along.order);
    made.numbers = even_.numbers - even_.errors[0].error + along.error;
    const Deviation off = runs_.off(made.trial, *even_.finest);
    made.verified = off.largest;
    made.worst = off.quantity;
    made.promised = promise(made, words_);
    made.within = made.promised <= within_ &&
                  runs_.at_rest_where_finer_moves(made.trial, *even_.finest).empty();
    return made;
  }

  AdviceRuns& runs_;
  const Candidate& even_;
  double within_;
  Scene scene_;
  const std::vector<double>& bent_;
  double words_ = 0.0;  ///< error of the words [1]
};

}  // namespace

std::optional<Candidate> with_graded_segments(AdviceRuns& runs, const Candidate& even,
                                              double within) {
  const bool breaks = runs.outcome(even.trial).break_place.has_value();
  const double along = even.errors.empty() ? 0.0 : even.errors[0].error;
  if (breaks || !even.finest || runs.axes()[0].field->path != "beam.segments" ||
      !(along > kWorthLooking * even.numbers)) {
    return std::nullopt;
  }
  return Grading(runs, even, within).best();
}

}  // namespace plastica::sweeps
