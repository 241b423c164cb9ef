#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "sweeps/advise/discretization.hpp"
#include "sweeps/advise/outcome.hpp"
#include "sweeps/advise/word_axes.hpp"

namespace plastica::sweeps {

struct AdviceOptions {
  double within = 0.01;               ///< the error that is allowed [1], 0 … 1
  double budget = 0.0;                ///< CPU time of a run [s]: the best for it; 0: by `within`
  std::vector<std::string> probes{};  ///< names; empty: all of the scene
  int max_runs = 100;                 ///< >= 4
  /// Of all runs, segment-iterations by `kernel_cost`; a run that would take more than is left is
  /// stopped, see `cost_limit`.
  double max_work = 1e8;
  int threads = 0;          ///< 0: as many as the machine has
  StopFlag stop = nullptr;  ///< may be null
  /// Called after each run with their number, from any thread, one call at a time.
  std::function<void(int runs)> progress{};
};

/// What one axis of numbers adds to the error of the advised setting.
struct BudgetLine {
  double error = 0.0;       ///< estimate [1]
  double order = 0.0;       ///< with which it falls [1]
  bool order_seen = false;  ///< else it is supposed: 1, which is safe
};

/// Another word in the place of the chosen one.
struct OtherWord {
  std::size_t choice = 0;
  /// Over the chosen one [1]: of a model at the same numbers, of a method at the same error.
  double cost = 1.0;
  double error = 0.0;    ///< of a model against the richest, of a method of its axis [1]
  std::string reason{};  ///< why there is no error: it is infinite
};

/// What the choice on one axis of words came to.
struct WordLine {
  double error = 0.0;  ///< of a model against the richest [1]; of a method it is in the numbers
  std::vector<OtherWord> others{};  ///< those that were run, in the order of the choices
};

/// A setting that was run, and how far it is off the finest run of the advice.
struct TriedSetting {
  Setting setting;
  Words words{};
  std::vector<double> fractions{};  ///< lengths of the segments over the beam's; empty: even
  double error = 0.0;               ///< [1]; infinite where the two cannot be compared
  std::string reason{};             ///< why they cannot
  std::int64_t work = 0;            ///< segment-iterations
  double cost = 0.0;                ///< work by `kernel_cost`
  double seconds = 0.0;             ///< CPU time
};

enum class AdviceEnd {
  Found,        ///< the setting is within what was asked for
  TooManyRuns,  ///< none was within it when the runs were used up
  TooMuchWork,  ///< the next runs would have taken more work than is allowed, or did
  Diverging,    ///< refinement does not make the error smaller
  TooDear,      ///< what is cheapest takes more time than the budget
  AtFinest,     ///< none was within it at the finest values of the axes
  Interrupted,
};

struct Advice {
  AdviceEnd end = AdviceEnd::TooManyRuns;
  /// For a budget: what ended the search before it was used; a more accurate setting may fit.
  std::optional<AdviceEnd> cut_short;
  std::vector<FinenessAxis> axes;     ///< that act with the advised words
  Setting setting;                    ///< advised; else the last one (n_axes)
  std::vector<double> fractions;      ///< of graded segments, as of `TriedSetting`; empty: even
  std::optional<TriedSetting> even;   ///< of graded segments: the best that even ones do
  std::vector<BudgetLine> budget;     ///< (n_axes)
  std::vector<WordAxis> word_axes;    ///< on which the scene has a choice
  Words words;                        ///< advised; else the last ones (n_word_axes)
  std::vector<WordLine> word_budget;  ///< (n_word_axes); empty: words were not decided
  double promised = 0.0;  ///< the error is at most this, of the worst quantity, models included [1]
  /// Difference from a run that is finer in every axis, and richest in every word that matters; at
  /// most, where that run had the advised words [1].
  double verified = 0.0;
  bool words_settled = false;  ///< whether it had the advised words, see `measure_settled`
  double of_words = 0.0;       ///< what is in `verified` for these words then [1]
  std::string worst;           ///< quantity whose error is the largest
  std::string reason;          ///< why no error can be said, where it cannot
  std::int64_t work = 0;       ///< of the setting, segment-iterations
  double cost = 0.0;           ///< work by `kernel_cost`
  double seconds = 0.0;        ///< CPU time
  /// Its work times the median CPU time that runs with its words and about its work took for each
  /// segment-iteration [s]: times of single runs are noisy.
  double expected_seconds = 0.0;
  std::optional<TriedSetting> next_cheaper;  ///< the dearest of the cheaper ones that do not do
  TriedSetting own;                          ///< the scene's file as it is, if it was run
  std::vector<TriedSetting> tried;           ///< all that ran to an end that can be used
  std::vector<std::string> left_out;         ///< probes that are given, or errors themselves
  std::vector<std::string> warnings{};       ///< of the setting, see `run_warnings`
  int runs = 0;
  double total_seconds = 0.0;   ///< CPU time of all runs
  std::int64_t total_work = 0;  ///< of all runs
};

/// Finds the cheapest model and discretization of a scene whose error is within what is allowed.
///
/// It begins coarse. Each setting is run together with one that is finer in each axis alone; their
/// differences say what each axis adds (`left_of`), two settings the order with which it falls.
/// From these follows the next setting (`next_setting`). Where numbers are close enough, the words
/// are decided (`WordChooser`): the richest models and, beside them, each simpler one. Where the
/// sum over numbers and words is small enough, what the words leave out is measured once more, and
/// the setting is run finer in every axis at once and richest in every word, or with its own words,
/// if what they leave out has settled (`measure_settled`) and is added: what is promised is the
/// larger of the sum and of what that run shows. Errors are the largest of `deviation`'s
/// quantities. Last, graded segments are tried in the place of even ones (`graded_fractions`),
/// unless it is for a budget.
/// @throws InputError for a coupon, a probe that is not there, a scene that cannot be run
Advice advise(const Setup& setup, const AdviceOptions& options);

/// The scene with what is advised.
Setup advised_setup(const Setup& setup, const Advice& advice);

/// Models whose runs differ by less are the same but for rounding and the solver's tolerance [1].
inline constexpr double kSameWord = 1e-7;

/// The scene finer than advised in every axis, and richest in every word (in space only if that has
/// made a difference, see `kSameWord`): what the promise is about.
/// @param factor  on the sizes of the axes, 0 … 1
Setup finer_setup(const Setup& setup, const Advice& advice, double factor);

}  // namespace plastica::sweeps
