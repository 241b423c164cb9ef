#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/store/journaled_fits.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Fits a batch of curves and survives its interruption, see JournaledFits: a later run takes from
/// the journal all those fits whose target, options, library version and instruction set are still
/// the same.
///
///     JournaledBatch batch(targets, options,
///                          {.journal = {.path = io::journal_path(output), .resume = true}});
///     std::vector<FitResult> results = batch.run();
///     if (!batch.complete()) return;  // stopped: the journal keeps what is done
///     write_fit_store(output, …);
///     batch.finish();  // the journal has done its work
class JournaledBatch : public JournaledFits<FitResult> {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param targets  must live until `run` has ended, as `options` must
  /// @throws InputError if the options are bad or two targets have the same name; if there is the
  /// journal of an interrupted run that
  ///         is neither to be resumed nor overwritten, or of another version and not to be
  ///         overwritten; if there is some other file in its place
  /// @throws io::StorageError if the journal cannot be read or written, or another run has it
  JournaledBatch(std::span<const Target> targets, const FitOptions& options, JournaledOptions how);

  /// What result i is of.
  const std::vector<FitCase>& cases() const { return cases_; }

  /// Fits what is missing. Result i belongs to case i; a fit that was not begun, because of the
  /// stop flag, has the reason "not run", as those of other shards have. To be called once.
  /// @throws InputError as `fit_target`; io::StorageError if the journal cannot be written. What
  ///         was finished before is in the journal.
  std::vector<FitResult> run();

 private:
  /// Gives those of the journal their curves, which it only counts.
  void remake_curves(std::vector<FitResult>& results) const;

  std::span<const Target> targets_;
  const FitOptions& options_;
  std::vector<FitCase> cases_;
};

/// Who a run of fits is, as its result file says: of targets, options, library version and
/// instruction set.
/// @param threads  0: as many as the machine has; changes nothing
std::string run_id(std::span<const Target> targets, const FitOptions& options, int threads);

}  // namespace plastica::calibrate
