#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sweeps/advise/advice_runs.hpp"
#include "sweeps/advise/next_setting.hpp"

/// Decides the words of a scene; not installed.
namespace plastica::sweeps {

/// What of the allowed error words may take.
inline constexpr double kWordsShare = 0.7;

/// Decides how a scene is modelled, and by which methods it is solved.
///
/// Models, at one setting of the numbers: the richest words are run, and beside them each simpler
/// word in the place of its richest. Their differences are the errors of the words. Of all
/// combinations whose errors leave enough for the numbers, the one is taken that is expected to
/// cost least: the product of the words' costs, times (W/(W - sum of their errors))^(sum 1/p_k), W
/// what is allowed, since numbers must be as much finer. Methods: each is run at the setting; its
/// error along its axis and its order foretell what it costs where the error is what its axis may
/// have.
class WordChooser {
 public:
  explicit WordChooser(AdviceRuns& runs);

  /// Chooses the words of a trial.
  /// @param errors  of the numbers there (n_axes)
  /// @param within  the error that is allowed [1]
  /// @return false if runs or work are used up, see `AdviceRuns::end`
  bool decide(const Trial& trial, const std::vector<AxisError>& errors, double within);
  bool decided() const { return decided_; }
  /// Asks for another decision, at a setting that is closer to the one to be advised.
  void doubt() { decided_ = false; }

  /// Measures again, at a setting, what the chosen models leave out, and what the next simpler ones
  /// would.
  /// @param all  those, too, that have left out next to nothing: what does not yield in a coarse
  ///             beam may in a finer one
  /// @return as `decide`
  bool confirm(const Trial& trial, double within, bool all);
  /// The run with the richest words beside which they were decided.
  const Trial& decided_at() const { return richest_; }
  /// The trial with the richest of all models, in space only if that has made a difference.
  Trial enriched(const Trial& trial) const;

  /// The trial, or that with joints that shift, where rigid ones do not let the beam move at all:
  /// two supports hold it along its axis. False: as `decide`
  bool let_move(Trial& trial);

  /// From now on the methods are those of the scene's file. @return the trial by these
  Trial with_own_methods(Trial trial);

  const Words& words() const { return words_; }
  const std::vector<WordLine>& lines() const { return lines_; }
  /// Of all words [1].
  double error() const;

 private:
  struct Option {
    std::size_t choice = 0;
    double cost = 1.0;  ///< over that of the richest as it is run [1]
    double error = 0.0;
    std::string reason{};
  };

  bool has_choice(std::size_t w) const;
  /// The trial with a scheme that takes every model.
  Trial comparable(Trial trial) const;
  Trial with(Trial trial, std::size_t w, std::size_t choice) const;
  /// Notes in `same_level_` a level that is as good as space, so that nothing else runs there.
  bool compare_levels(const Trial& trial);
  bool run_richest(const Trial& trial);
  bool run_models(const Trial& trial);
  /// Measures a choice at the place of a trial's, against the richest of its axis.
  bool compare(Trial trial, std::size_t w, std::size_t choice, OtherWord& found);
  void note_option(std::size_t w, std::size_t choice);
  void choose_models(const Trial& trial, const std::vector<AxisError>& errors);
  bool choose_method(const Trial& trial, std::size_t w, const std::vector<AxisError>& errors);
  void fill_lines();

  AdviceRuns& runs_;
  double within_ = 0.0;  ///< of the decision that is being made
  bool decided_ = false;
  bool own_methods_ = false;
  Words words_;
  std::size_t same_level_ = 0;                ///< number of its axis; that of axes: none
  Trial richest_{};                           ///< as it was run last
  std::vector<std::vector<Option>> options_;  ///< by axis of words, of models, the richest last
  std::vector<WordLine> lines_;
};

}  // namespace plastica::sweeps
