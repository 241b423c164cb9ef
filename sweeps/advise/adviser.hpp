#pragma once

#include <optional>
#include <vector>

#include "sweeps/advise/advice_runs.hpp"
#include "sweeps/advise/axis_models.hpp"
#include "sweeps/advise/fill_advice.hpp"
#include "sweeps/advise/settled_words.hpp"
#include "sweeps/advise/word_chooser.hpp"

/// The search for the cheapest setting within an error; not installed.
namespace plastica::sweeps {

/// Searches with the runs that it has, as often as it is asked to.
class Adviser {
 public:
  explicit Adviser(AdviceRuns& runs);

  /// Finds the cheapest within an error [1], or says in `end` why there is none.
  /// @param start  where it begins; empty: at the coarsest
  void search(double within, const std::optional<Trial>& start = {});
  /// Looks at one setting alone, after a search: it is the best if it is within an error [1].
  void look_at(double within, const Trial& trial);
  const std::optional<Candidate>& best() const { return best_; }
  /// The last one that was looked at.
  const Candidate& last() const { return now_; }
  /// The run that the last verification compared with.
  const std::optional<Trial>& finest() const { return finest_; }
  AdviceEnd end() const { return end_; }

 private:
  static constexpr double kRefined = 0.5;  ///< factor on a size that is made finer

  /// Begins anew from a setting.
  void begin(double within, const Trial& trial);
  Trial coarsest() const;
  Trial finer(const Trial& trial, std::size_t axis) const;
  /// On every number's size: a factor for what matters, a larger one for what hardly does.
  std::vector<double> factors_in_all(const Candidate& candidate, double factor) const;
  /// The order that an axis has by its method.
  double supposed_order(std::size_t axis, const Trial& trial) const;
  /// Whether the error along an axis need not be measured.
  bool is_foretold(std::size_t axis, const Candidate& candidate) const;
  /// Whether an axis that matters has shown no order.
  bool rests_on_unseen(const Candidate& candidate, std::size_t axis) const;
  /// Whether a run has ended otherwise than this one.
  bool outcomes_vary(const Trial& trial) const;
  /// What the axes of numbers add. False, as in all below: runs or work are used up.
  bool estimate(Candidate& candidate);
  /// Names the quantity of the largest error of an axis; the one that was named before stays where
  /// an error is unknown.
  void name_worst(Candidate& candidate) const;
  void forget_methods(const Words& before, const Words& after);
  /// Decides the words where numbers are close enough. `changed`: the candidate has other ones now.
  bool settle_words(Candidate& candidate, bool& changed);
  /// Runs a candidate finer in every axis, and richest in every word unless `richest` is false;
  /// only then it is `finest`.
  bool run_finest(const Candidate& candidate, const std::vector<double>& factors, bool richest);
  /// Looks whether the run that verifies may have the candidate's own words, where that costs less
  /// than the richest ones and no run has ended otherwise.
  bool look_whether_settled(const Candidate& candidate, const std::vector<double>& factors,
                            SettledWords& settled);
  /// Measures the axes in which errors of unlike orders may cancel at two sizes in a row.
  bool measure_hidden(Candidate& candidate);
  /// Measures what the words leave out, and runs the finest beside the candidate.
  bool verify(Candidate& candidate);
  /// Looks whether what is at rest in a candidate, and in the run that verifies it, moves in a
  /// finer run, among them that of the scene's file: two coarse beams may both not yield.
  bool look_for_rest(Candidate& candidate);
  bool judge(Candidate& candidate);
  /// Where all that is probed stays within rounding: from a setting that is far finer, by the
  /// file's own methods, if anything moves there. What the ends of a coarse beam hold may.
  /// @throws InputError if nothing does
  bool go_on_if_finer_moves(Candidate& candidate);
  Trial next_of(const Candidate& candidate);
  /// Whether refinement has stopped to help: the sum has not fallen for some settings.
  bool diverges(const Candidate& candidate);
  /// Goes on from where it is by the scene's own methods, where those that were chosen lead
  /// nowhere.
  /// @return false if it has them already
  bool try_own_methods();

  AdviceRuns& runs_;
  double within_ = 0.0;  ///< the error that is allowed [1]
  AxisModels models_;
  WordChooser words_;
  Candidate now_{};
  std::optional<Candidate> best_{};
  std::optional<Trial> finest_{};
  bool measure_all_ = false;  ///< what was foretold of the candidate is not to be trusted
  bool moves_ = false;        ///< whether any quantity of the last estimates is beyond rounding
  bool alone_ = false;        ///< only the candidate is looked at, no other is taken in its place
  double share_ = 0.0;        ///< of the allowed error, for the numbers
  int decisions_ = 0;
  AdviceEnd end_ = AdviceEnd::AtFinest;
  double least_sum_ = 0.0;
  int since_least_ = 0;  ///< settings whose sum was not less
};

}  // namespace plastica::sweeps
