#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/base/team.hpp"
#include "plastica/io/case_journal.hpp"
#include "sweeps/plan/sweep.hpp"
#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// How far a sweep has come.
struct SweepProgress {
  std::size_t done = 0;     ///< those that were resumed from earlier runs included
  std::size_t failed = 0;   ///< of the done: without a usable status
  std::size_t resumed = 0;  ///< of the done: from earlier runs, so that they took no time
  std::size_t total = 0;
};

/// Results of an earlier run by the ids of their cases.
using EarlierResults = std::unordered_map<std::string, CaseResult>;

struct SweepRunOptions {
  io::JournalPolicy journal{};  ///< without a path nothing is kept
  EarlierResults earlier{};     ///< of the output that is to be replaced
  bool rerun_failed = false;    ///< take no failed case from journal or earlier results
  int threads = 0;              ///< 0: as many as the machine has; one if cases are timed
  /// Once raised, no further case is begun, and those under way end within a step of theirs and
  /// count as not begun. May be null.
  StopFlag stop = nullptr;
};

/// Runs the cases of a sweep, each once, and survives interruption: every finished case goes to a
/// journal. The results have the same bits as those of a run without interruption, but for times.
/// Several processes may do them together, see `io::JournalPolicy::team`: the one that leads has
/// the results of all.
class SweepRun {
 public:
  /// Reads the journal, if one is there, and opens it for writing; computes nothing.
  /// @param sweep  must outlive this
  /// @throws InputError, io::StorageError as `io::CaseJournal`; InputError if journal and earlier
  ///         results hold cases, but none of this sweep, and are not to be overwritten
  SweepRun(const Sweep& sweep, SweepRunOptions options);

  const CaseTable& cases() const { return cases_; }
  /// Ids of all cases, in their order.
  const std::vector<std::string>& ids() const { return ids_; }
  /// Number of cases resumed from journal and earlier results.
  std::size_t resumed() const { return resumed_; }
  /// Number of cases to be done, of a shard its own, those resumed included.
  std::size_t own() const { return progress_.total; }
  /// Null where no journal is kept.
  const io::CaseJournal* journal() const { return journal_ ? &*journal_ : nullptr; }

  /// Sets what is told how far the sweep is: once before the first case and after each, one call at
  /// a time, from any thread.
  void on_progress(std::function<void(const SweepProgress&)> report) {
    report_ = std::move(report);
  }

  /// Runs what is missing. Result i is that of case i, NotRun for one that was not begun. To be
  /// called once. @throws io::StorageError if the journal cannot be written; InputError if cases
  /// that may run side by side do not fit into the machine's memory
  std::vector<CaseResult> run();
  /// Whether `run` has results of all cases, of a shard all its own. Of a team only its leader
  /// knows.
  bool complete() const { return complete_; }
  /// Whether the results are those of all cases here: false in a process that does not lead.
  bool leads() const { return team() == nullptr || team()->leads(); }
  /// Says in a shard's file that it has all of its cases.
  /// @throws std::logic_error if it is not complete; io::StorageError
  void end_shard();
  /// Deletes the journal, once the results are stored. @throws io::StorageError
  void finish();

 private:
  void take(std::size_t index, CaseResult result);
  void count(std::size_t index, const CaseResult& result);
  void take_earlier();
  void deal();
  void run_missing(const std::vector<std::size_t>& missing, const NextIndex& next);
  void gather();
  void tell() const;
  Team* team() const { return options_.journal.team; }
  void check_memory_of(const std::vector<std::size_t>& missing) const;

  const Sweep& sweep_;
  SweepRunOptions options_;
  CaseTable cases_;
  std::vector<std::string> ids_;
  std::vector<std::size_t> owner_;      ///< first case of the same id (n_cases)
  std::vector<std::size_t> shared_by_;  ///< how many cases have the id of an owner (n_cases)
  std::vector<bool> watched_;           ///< whether an owner's warnings are kept (n_cases)
  std::vector<bool> own_;               ///< whether a case is to be done here (n_cases)
  std::optional<io::CaseJournal> journal_;
  std::vector<std::optional<CaseResult>> results_;  ///< of owners (n_cases)
  std::size_t found_ = 0;  ///< cases of this sweep in journal and earlier results
  std::size_t resumed_ = 0;
  SweepProgress progress_;
  SweepProgress before_;   ///< when the run began
  Team::Counts others_{};  ///< done, failed: what other processes have told
  std::mutex mutex_;       ///< of the progress
  std::function<void(const SweepProgress&)> report_;
  bool complete_ = false;
};

}  // namespace plastica::sweeps
