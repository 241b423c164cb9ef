#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"
#include "calibrate/store/journaled_batch.hpp"

namespace plastica::calibrate {

/// Fits cases through scenes and survives its interruption, as `JournaledBatch` does for curves.
/// Several cases are fitted side by side, a lone one has its scenes run side by side. The searches
/// of a fit that have ended are kept, too, and a stop is heeded between the steps of its runs.
///
/// Where the options name laws, each case is fitted by each of them, simpler ones first: their best
/// points are starts of those that contain them. Each law has its search, errors and verdicts. What
/// is made of a chosen fit (other numbers of segments, intervals) is made of the law alone that is
/// advised for all cases, from the same search.
class JournaledSceneFits {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param cases, options  must outlive the batch; the hooks of the options are not used
  /// @param within  called as a lone fit goes on, see `SceneFitHooks::progress`; may be empty
  /// @throws InputError, io::StorageError as `io::CaseJournal`
  JournaledSceneFits(std::span<const SceneFitCase> cases, const SceneFitOptions& options,
                     JournaledOptions how,
                     std::function<void(const SceneFitProgress&)> within = {});
  JournaledSceneFits(const JournaledSceneFits&) = delete;
  JournaledSceneFits& operator=(const JournaledSceneFits&) = delete;

  std::size_t resumed() const { return resumed_; }  ///< fits that the journal had
  std::size_t stages() const { return stages_; }    ///< finished stages of others that it had
  std::size_t stale() const { return stale_; }      ///< and stale ones
  std::uint64_t dropped_bytes() const { return journal_.dropped_bytes(); }
  /// See `io::CaseJournal`.
  const std::string& other_instruction_set() const { return journal_.other_instruction_set(); }
  int resumptions() const { return journal_.resumptions(); }

  /// Says what the run computes: a digest of its cases, options and library version. Two runs with
  /// the same have the same results, bit by bit.
  std::string run_id() const;

  /// Whose fit a result is.
  struct Fit {
    std::size_t of = 0;      ///< case
    std::optional<Law> law;  ///< empty: that of its scenes
  };
  /// One a case, or one a law for each case, in the order of the results.
  const std::vector<Fit>& fits() const { return fits_; }
  /// Time that each took, of laws without what is made of the advised one alone; NaN: resumed from
  /// the journal [s] (n_fits).
  const std::vector<double>& seconds() const { return seconds_; }

  /// Fits what is missing. To be called once. Of several cases one whose input is bad has failed.
  /// @throws InputError for the bad input of a lone case
  std::vector<SceneFitResult> run();
  /// Whether `run` fitted all.
  bool complete() const { return complete_; }
  /// Deletes the journal, once the results of a complete run are stored elsewhere.
  void finish();
  /// Deletes the journal, since an output has the results of the same run already.
  /// @throws io::StorageError
  void discard() { journal_.finish(); }

 private:
  /// What a fit's searches have kept, by their names.
  using Kept = std::map<std::string, std::vector<std::byte>>;

  bool makes_complete() const;
  std::size_t first_fit(std::size_t of) const { return of * fits_.size() / cases_.size(); }
  void take_from_journal();
  void fit_side_by_side(const std::vector<std::size_t>& of, std::optional<Law> complete);
  std::optional<SceneFitResult> fit(std::size_t index, bool complete);
  SceneFitResult fit_law(std::size_t index, bool complete, SceneFitOptions options) const;
  void take(std::size_t index, bool complete, SceneFitResult&& result);
  Law advised() const;

  std::span<const SceneFitCase> cases_;
  const SceneFitOptions& options_;
  JournaledOptions how_;
  std::function<void(const SceneFitProgress&)> within_;
  std::vector<Fit> fits_;
  std::vector<std::string> ids_;                        ///< of the fits
  std::vector<std::string> complete_ids_;               ///< of the same as those of the advised law
  std::vector<std::optional<SceneFitResult>> results_;  ///< (n_fits)
  std::vector<double> seconds_;
  std::vector<Kept> kept_;  ///< (n_fits)
  std::mutex mutex_;        ///< of what counts them
  BatchProgress progress_;
  std::size_t completed_ = 0;  ///< fits of the advised law that have all that is made of it
  int threads_ = 1;            ///< that each fit has
  io::CaseJournal journal_;
  std::size_t resumed_ = 0;
  std::size_t stages_ = 0;
  std::size_t stale_ = 0;
  bool complete_ = false;
};

}  // namespace plastica::calibrate
