#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/result/scene_fit_record.hpp"
#include "calibrate/store/journaled_fits.hpp"

namespace plastica::calibrate {

/// Refuses what cannot be dealt into shards: what is made of the law that all fits advise.
/// @throws InputError
void check_dealt(const SceneFitOptions& options);

/// Fits cases through scenes and survives its interruption, see JournaledFits. Several cases are
/// fitted side by side, a lone one has its scenes run side by side. The searches of a fit that have
/// ended are kept, too, and a stop is heeded between the steps of its runs.
///
/// Where the options name laws, each case is fitted by each of them, simpler ones first: their best
/// points are starts of those that contain them. Each law has its search, errors and verdicts. What
/// is made of a chosen fit (other numbers of segments, intervals) is made of the law alone that is
/// advised for all cases, from the same search.
class JournaledSceneFits : public JournaledFits<SceneFitResult> {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param cases, options  must outlive the batch; the hooks of the options are not used
  /// @param within  called as a lone fit goes on, see `SceneFitHooks::progress`; may be empty
  /// @throws InputError, io::StorageError as `io::CaseJournal`
  JournaledSceneFits(std::span<const SceneFitCase> cases, const SceneFitOptions& options,
                     JournaledOptions how,
                     std::function<void(const SceneFitProgress&)> within = {});

  /// Finished stages of fits that have not ended, of the journal.
  std::size_t stages() const { return stages_; }

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

 private:
  /// What a fit's searches have kept, by their names.
  using Kept = std::map<std::string, std::vector<std::byte>>;

  /// Of cases, options, library version and instruction sets.
  std::string make_run_id() const;
  std::size_t first_fit(std::size_t of) const { return of * fits_.size() / cases_.size(); }
  void fit_side_by_side(const std::vector<std::size_t>& of, std::optional<Law> complete,
                        const NextIndex& next);
  void complete_advised();
  std::optional<SceneFitResult> fit(std::size_t index, bool complete);
  SceneFitResult fit_law(std::size_t index, bool complete, SceneFitOptions options) const;
  Law advised() const;

  std::span<const SceneFitCase> cases_;
  const SceneFitOptions& options_;
  std::function<void(const SceneFitProgress&)> within_;
  std::vector<Fit> fits_;
  std::vector<std::string> complete_ids_;  ///< of the same as those of the advised law
  std::vector<double> seconds_;
  std::vector<Kept> stages_kept_;  ///< (n_fits)
  /// Whether a fit of the advised law has all that is made of it (n_fits).
  std::vector<char> completed_;
  bool advised_is_complete_ = false;
  int threads_ = 1;  ///< that each fit has
  std::size_t stages_ = 0;
};

}  // namespace plastica::calibrate
