#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/base/team.hpp"
#include "plastica/io/case_journal.hpp"

namespace plastica::calibrate {

/// How far a run of fits has come.
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
  /// Of specimens: results only count the samples of their curves, which `remade_curve` makes when
  /// they are written. Else they have them.
  bool counts_curves = false;
};

/// Fits that survive the interruption of their run, whatever they are of: each that has ended goes
/// to a journal under an id, which is a name and a digest of all that decides its bits, and a later
/// run takes from it those whose ids it has, too. The results have the same bits as those of a run
/// without interruption. Several processes may do them together, see `io::JournalPolicy::team`: the
/// one that leads has the results of all.
/// @tparam Result  FitResult or SceneFitResult
template <typename Result>
class JournaledFits {
 public:
  JournaledFits(const JournaledFits&) = delete;
  JournaledFits& operator=(const JournaledFits&) = delete;

  /// Number of fits resumed from the journal.
  std::size_t resumed() const { return progress_.resumed; }
  /// Number of records in the journal that are stale: what they are of has changed.
  std::size_t stale() const { return stale_; }
  /// Bytes at the journal's end that were dropped: a record torn by a crash. 0: none.
  std::uint64_t dropped_bytes() const { return journal_.dropped_bytes(); }
  /// See `io::CaseJournal`.
  const std::string& other_instruction_set() const { return journal_.other_instruction_set(); }
  /// How often this run was interrupted and resumed, this time included.
  int resumptions() const { return journal_.resumptions(); }

  /// Whether all was fitted, of a shard all that is its own. Of a team only its leader knows.
  bool complete() const { return complete_; }
  /// Whether the results are those of all fits here: false in a process that does not lead.
  bool leads() const { return team() == nullptr || team()->leads(); }
  /// See `io::CaseJournal`.
  std::size_t damaged() const { return journal_.damaged(); }
  std::size_t merged_shards() const { return journal_.merged_shards(); }
  /// Whether a shard's file was found that has all of its fits.
  bool shard_ended() const { return journal_.shard_ended(); }
  /// Fits that a run, or its shard, has to do, those of the journal included.
  std::size_t own() const { return progress_.total; }
  /// All fits.
  std::size_t size() const { return ids_.size(); }
  /// See `run_id_of`: of all that decides the results.
  const std::string& run_id() const { return run_id_; }
  /// Says in a shard's file that it has all of its fits.
  /// @throws std::logic_error if it is not complete; io::StorageError
  void end_shard();
  /// Deletes the journal, once the results of a complete run are stored elsewhere.
  /// @throws std::logic_error if it is not complete; io::StorageError
  void finish();
  /// Deletes the journal, since an output has the results of the same run already.
  /// @throws io::StorageError
  void discard() { journal_.finish(); }

 protected:
  /// Reads the journal, if one is there, and opens it for writing.
  /// @param kind  says what its records are
  /// @param noun  what they are called in messages
  /// @throws InputError, io::StorageError as `io::CaseJournal`
  JournaledFits(JournaledOptions how, std::uint64_t kind, std::string_view noun);
  ~JournaledFits() = default;

  /// Says what is computed, and deals the fits where it is a shard. `ids_` is to be there.
  /// @param run  see `run_id_of`
  /// @param together  as many fits as go to one shard, one behind the other
  /// @throws InputError as `io::CaseJournal::begin`
  void deal(const std::string& run, std::size_t together = 1);
  /// Takes the results of its own fits that the journal has.
  /// @param usable  told each, which it may change; false: it is stale, whatever its id. Empty: all
  ///                are usable
  void resume(const std::function<bool(std::size_t index, Result&)>& usable = {});
  /// Whether a fit is to be done here.
  bool is_own(std::size_t index) const { return own_[index]; }
  /// To be called once, before the first fit. @throws std::logic_error when it is called again
  void start_run();
  /// Keeps a fit that has ended, and tells so; may be called by several threads.
  void keep(std::size_t index, const Result& result);
  /// Takes into `results_` the fits that other processes of a team have kept.
  /// @param everyone  in all processes; false: in the one that leads
  void gather(bool everyone);
  /// Syncs what is kept of a run that was stopped.
  void end_run(bool complete);
  /// The processes that compute the run together; null: there is one.
  Team* team() const { return how_.journal.team; }

  JournaledOptions how_;
  std::vector<std::string> ids_;  ///< of the fits (n_fits)
  /// Those of the journal (n_fits); null where it has none, as mostly: a result is large.
  std::vector<std::unique_ptr<Result>> results_;
  BatchProgress progress_;
  std::size_t stale_ = 0;
  io::CaseJournal journal_;

 private:
  void count(const Result& result);
  void tell() const;

  std::vector<bool> own_;   ///< (n_fits)
  std::vector<char> kept_;  ///< whether a fit has been done in this process (n_fits)
  BatchProgress before_;    ///< when the run began
  Team::Counts others_{};   ///< done, failed, rejected: what other processes have told
  std::string run_id_;
  std::mutex mutex_;  ///< of the progress
  bool has_run_ = false;
  bool complete_ = false;
};

/// Says what a run computes, as a digest of its ids in whatever order they come, as results are
/// stored. Two runs with the same have the same results, bit by bit.
/// @param besides  what else the results depend on, if there is something
std::string run_id_of(std::vector<std::string> ids, std::optional<std::uint64_t> besides = {});

}  // namespace plastica::calibrate
