#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/options.hpp"
#include "calibrate/result/result.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/io/case_journal.hpp"

namespace plastica::calibrate {

/// How far a batch has come.
struct BatchProgress {
  std::size_t done = 0;  ///< fitted, failed and rejected, those of the journal included
  std::size_t failed = 0;
  std::size_t rejected = 0;
  std::size_t resumed = 0;  ///< of the done: resumed from the journal, so that they took no time
  std::size_t total = 0;
};

struct JournaledOptions {
  io::JournalPolicy journal{};
  int threads = 0;  ///< 0: as many as the machine has
  /// Once raised, no further fit is begun, and those under way end soon and count as not begun. May
  /// be null.
  StopFlag stop = nullptr;
  /// Called once before the first fit and after each, one call at a time, from any thread.
  std::function<void(const BatchProgress&)> progress{};
};

/// Fits a batch and survives its interruption: each finished fit goes to a journal, and a later
/// run takes from it all those fits whose target, options, library version and instruction set are
/// still the same. The results have the same bits as those of a run without interruption.
///
///     JournaledBatch batch(targets, options, {.journal = {.path = io::journal_path(output),
///     .resume = true}}); std::vector<FitResult> results = batch.run(); if (!batch.complete())
///     return;  // stopped: the journal keeps what is done write_fit_store(output, …);
///     batch.finish();  // the journal has done its work
///
class JournaledBatch {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param targets  must outlive the batch, as `options` must
  /// @throws InputError if the options are bad or two targets have the same name; if there is the
  /// journal of an interrupted run that
  ///         is neither to be resumed nor overwritten, or of another version and not to be
  ///         overwritten; if there is some other file in its place
  /// @throws io::StorageError if the journal cannot be read or written, or another run has it
  JournaledBatch(std::span<const Target> targets, const FitOptions& options, JournaledOptions how);
  JournaledBatch(const JournaledBatch&) = delete;
  JournaledBatch& operator=(const JournaledBatch&) = delete;

  /// What result i is of.
  const std::vector<FitCase>& cases() const { return cases_; }
  /// Number of fits resumed from the journal.
  std::size_t resumed() const { return resumed_; }
  /// Number of fits in the journal that are stale: target or options have changed.
  std::size_t stale() const { return stale_; }
  /// Bytes at the journal's end that were dropped: a record torn by a crash. 0: none.
  std::uint64_t dropped_bytes() const { return journal_.dropped_bytes(); }

  /// Says what the run computes: a digest of its targets, options, library version and instruction
  /// set. Two runs with the same have the same results, bit by bit.
  std::string run_id() const;
  /// See `io::CaseJournal`.
  const std::string& other_instruction_set() const { return journal_.other_instruction_set(); }

  /// How often this batch was interrupted and resumed, this time included.
  int resumptions() const { return journal_.resumptions(); }

  /// Fits what is missing. Result i belongs to case i; a fit that was not begun, because of the
  /// stop flag, has the reason "not run". To be called once.
  /// @throws InputError as `fit_target`; io::StorageError if the journal cannot be written. What
  ///         was finished before is in the journal.
  std::vector<FitResult> run();
  /// Whether `run` fitted all cases.
  bool complete() const { return complete_; }
  /// Deletes the journal, once the results of a complete run are stored elsewhere.
  /// @throws io::StorageError
  void finish();
  /// Deletes the journal, since an output has the results of the same run already.
  /// @throws io::StorageError
  void discard() { journal_.finish(); }

 private:
  void take_from_journal();
  void count(const FitResult& result, BatchProgress& progress) const;
  void keep(std::size_t index, const FitResult& result);

  std::span<const Target> targets_;
  const FitOptions& options_;
  JournaledOptions how_;
  std::vector<FitCase> cases_;
  std::vector<std::string> ids_;                   ///< of the cases (n_cases)
  std::vector<std::optional<FitResult>> results_;  ///< those of the journal (n_cases)
  io::CaseJournal journal_;
  std::size_t resumed_ = 0;
  std::size_t stale_ = 0;
  bool has_run_ = false;
  bool complete_ = false;
};

}  // namespace plastica::calibrate
