#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sweeps/advise/advice.hpp"
#include "sweeps/advise/watched_probes.hpp"
#include "sweeps/run/limited_run.hpp"

/// The runs of an advice; not installed.
namespace plastica::sweeps {

/// A way to run the scene: its words, and its numbers on all axes (n_axes of the runs).
struct Trial {
  Words words;
  Setting setting;
  std::vector<double> fractions{};  ///< lengths of the segments over the beam's; empty: even

  friend bool operator==(const Trial&, const Trial&) = default;
  friend bool operator<(const Trial& a, const Trial& b) {
    return std::tie(a.words, a.setting, a.fractions) < std::tie(b.words, b.setting, b.fractions);
  }
};

/// What a run may cost at most.
struct CostLimit {
  double cost = 0.0;         ///< by `kernel_cost`
  bool of_all_work = false;  ///< it is what `AdviceOptions::max_work` leaves
};

/// The lesser of what is left of all work and 200 times what was foreseen: a run that takes so much
/// more is cut back again and again, and what it comes to is of no use to the advice.
/// @param left, foreseen  by `kernel_cost`, > 0; of steps without any iteration one each
CostLimit cost_limit(double left, double foreseen);

/// Runs a scene in different ways, each once, and keeps what they came to.
class AdviceRuns {
 public:
  /// @throws InputError for a scene that cannot be advised
  AdviceRuns(const Setup& setup, const AdviceOptions& options);

  /// The axes of numbers that any words have; some words do without some of them.
  const std::vector<FinenessAxis>& axes() const { return axes_; }
  const std::vector<WordAxis>& word_axes() const { return word_axes_; }
  std::vector<WordAxis>& word_axes() { return word_axes_; }
  const WatchedProbes& probes() const { return probes_; }

  Setup setup_of(const Trial& trial) const;
  /// Whether a number does anything with these words: fibres do nothing where joints have caps.
  bool acts(std::size_t axis, const Words& words) const;
  /// The trial as a run takes it: steps that divide the samples, and numbers that do nothing as the
  /// file has them (fibres 40; 16 to 40 where more than 1 % is allowed), so that what is one run is
  /// one trial.
  Trial taken(Trial trial) const;
  /// The trial with segments that end at the probes of places: by a quarter more, where so many
  /// even ones do, else even between these places.
  Trial with_ends_at_probes(Trial trial) const;
  /// That of the scene's file.
  Trial own() const;
  /// The sizes of all axes that act, times a factor each (n_axes). Where that of the segments, the
  /// first, is one over a whole number, each is divided; else they are with ends at probes.
  Trial scaled(const Trial& trial, const std::vector<double>& factors) const;

  /// Runs the trials, as taken, that were not run yet; each is stopped where it takes many times
  /// what was foreseen of it, or what work is left, see `cost_limit`. False: runs or work are used
  /// up, or it was stopped; `end` says which.
  bool run_all(std::vector<Trial> trials);
  bool has(const Trial& trial) const { return outcomes_.count(trial) > 0; }
  const Outcome& outcome(const Trial& trial) const { return outcomes_.at(trial); }
  const std::map<Trial, Outcome>& outcomes() const { return outcomes_; }
  /// @param than  as of `deviation`
  Deviation off(const Trial& coarse, const Trial& fine, std::string_view than = "finer") const {
    return deviation(outcome(coarse), outcome(fine), probes_.watched, than);
  }
  /// The name of a watched probe that stays within rounding in both runs, and moves in one that is
  /// no coarser than the first in any number and no simpler in any model; empty where there is
  /// none.
  std::string at_rest_where_finer_moves(const Trial& trial, const Trial& finer) const;
  /// Whether runs and work are left for a trial, as far as its work can be foreseen.
  bool affords(const Trial& trial) const;
  /// The work of a run by the cost of its kernels, see `kernel_cost`.
  double cost(const Trial& trial) const;
  /// The cost of a trial over that of another, if it goes with the number of segments and steps.
  double expected_cost(const Trial& from, const Trial& to) const;
  /// Of those of the trials that were not run: from those that came to an end; 0 where none has.
  double foreseen_cost(const std::vector<Trial>& trials) const;

  /// The CPU time of a trial that was run, see `Advice::expected_seconds` [s].
  double expected_seconds(const Trial& trial) const;

  AdviceEnd end() const { return end_; }
  int runs() const { return runs_; }

 private:
  bool is_as_fine_and_rich(const Trial& trial, const Trial& as) const;
  /// By counts of segments and steps alone.
  double expected_work(const Trial& from, const Trial& to) const;
  /// @param together  the trials that are run with it, itself among them
  CostLimit limit_of(const Trial& trial, const std::vector<Trial>& together) const;
  /// Runs a trial; what cannot be run is a row, too.
  LimitedRun run(const Trial& trial, const CostLimit& limit) const;

  const Setup& setup_;
  const AdviceOptions& options_;
  std::vector<WordAxis> word_axes_;
  std::vector<FinenessAxis> axes_;
  Setting own_setting_;
  Setting idle_setting_;  ///< of numbers that do nothing, until richer words need them
  WatchedProbes probes_;
  std::map<Trial, Outcome> outcomes_;
  int runs_ = 0;
  double cost_ = 0.0;  ///< of all runs
  AdviceEnd end_ = AdviceEnd::AtFinest;
};

}  // namespace plastica::sweeps
