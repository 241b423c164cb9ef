#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "plastica/io/journal.hpp"
#include "plastica/io/shard.hpp"

namespace plastica {
class Team;
}

namespace plastica::io {

/// Where the journal of an output stands: beside it, "OUT.h5.journal".
std::string journal_path(const std::string& output);

struct MergedShards;
struct FoundJournal;

/// Which shard of a run is computed, and by which command.
struct ShardOfRun {
  Shard shard;
  std::vector<std::string> words{};  ///< see `ShardMark::words`
};

/// What to do about the journal of an interrupted run.
struct JournalPolicy {
  std::string path{};   ///< of the journal, see `journal_path`, or of the shard, see `shard_path`
  bool resume = false;  ///< go on from it; start afresh where there is none
  bool force = false;   ///< start afresh, over it
  /// Name of the one that the run computes with, to be told from that of an earlier run.
  std::string instruction_set{};
  std::optional<ShardOfRun> shard{};  ///< empty: all of the run
  /// All cases of the run, which are taken in place of a journal: nothing is computed, and what
  /// stands at `path` is left alone. Null: there are none.
  const MergedShards* merged = nullptr;
  /// The processes that compute the run together, each with a journal of its own, see
  /// `team_journal_path`. Then all that throws, throws TeamLeft, too. Null: there is one.
  Team* team = nullptr;
};

/// The finished cases of a batch that survives its interruption: those that an earlier run has left
/// in the journal, be it one process or several, and a place for the next ones. A journal without
/// any case in it is never left behind.
class CaseJournal {
  struct Marks;

 public:
  /// Reads the journal, if one is there, and opens it for writing.
  /// @param kind  says what its records are: a digest of their name and version
  /// @param noun  what a case is called in messages, in the plural: "fits"
  /// @throws InputError if there is the journal of an interrupted run that is neither to be resumed
  ///         nor overwritten, or of another version and not to be overwritten, or some other file
  /// @throws StorageError if it cannot be read or written, or another run has it
  CaseJournal(const JournalPolicy& policy, std::uint64_t kind, std::string_view noun);
  ~CaseJournal();
  CaseJournal(CaseJournal&&) = delete;
  CaseJournal& operator=(CaseJournal&&) = delete;

  /// What an earlier run has stored of a case; null if nothing.
  const std::vector<std::byte>* find(std::string_view id) const;
  /// How many cases an earlier run has stored.
  std::size_t found() const { return found_.size(); }
  /// How many of these, with those that were gathered, are none of some ids.
  std::size_t found_besides(const std::unordered_set<std::string>& ids) const;
  /// How many of these have an id that begins so: parts of a case.
  std::size_t found_under(std::string_view beginning) const;
  /// Bytes at the journal's end that were dropped: a record torn by a crash. 0: none.
  std::uint64_t dropped_bytes() const { return dropped_bytes_; }
  /// Stretches of damaged bytes between the cases that were found. What they had is lost.
  std::size_t damaged() const { return damaged_; }
  /// The instruction set of the run that began the journal, if it was another one; else empty. The
  /// cases whose bits depend on it are then not those of this run.
  const std::string& other_instruction_set() const { return other_instruction_set_; }
  /// How often the batch was interrupted and resumed, this time included.
  int resumptions() const { return resumptions_; }

  /// Says what the run computes, of which the cases are; to be called once, before a case is kept.
  /// Of a shard the file then says so, too.
  /// @param run  a digest of all that decides the results
  /// @param ids  of all cases (n)
  /// @param together  as many cases as go to one shard, one behind the other
  /// @return which of them are to be computed: all, or the shard's own (n)
  /// @throws InputError if the file is another shard, or the shards that are there are of another
  ///         run, or lack a case
  std::vector<bool> begin(const std::string& run, std::span<const std::string> ids,
                          std::size_t together = 1);
  /// How many shards all cases were merged of; 0: they were not.
  std::size_t merged_shards() const { return merged_ ? merged_->shard.count : 0; }
  /// Says in a shard's file that all of its cases are there. @throws StorageError
  void end_shard();
  /// Whether it said so when it was found, and has them all. To be asked after `begin`.
  bool shard_ended() const { return shard_ended_; }

  /// Adds a finished case; may be called by several threads. @throws StorageError
  void keep(std::string_view id, std::span<const std::byte> payload);
  /// Forces all cases to the disk now. @throws StorageError
  void sync();
  /// Lets `find` and `find_gathered` know what the other processes of a team have kept. To be
  /// called by all of them, which keep nothing meanwhile.
  /// @param everyone  in all processes; false: in process 0
  /// @throws StorageError
  void gather(bool everyone);
  /// What another process of the team has kept of a case, in this run; null if nothing.
  const std::vector<std::byte>* find_gathered(std::string_view id) const;
  /// Deletes the journal, and those of a team, once all cases are stored elsewhere.
  /// Does nothing in other processes than process 0. @throws StorageError
  void finish();

 private:
  void lead(const JournalPolicy& policy, std::string_view noun);
  void go_on(std::vector<FoundJournal> found, const Marks& marks);
  void follow();
  void mark_instruction_set();
  void remove_if_empty();
  void take_records(std::vector<JournalRecord> records);
  std::uint64_t digest_of_found() const;
  void take_merged(const MergedShards& merged, std::uint64_t kind);
  void check_merged(const std::string& run, std::span<const std::string> ids,
                    std::size_t together) const;
  std::vector<bool> begin_shard(const std::string& run, std::span<const std::string> ids,
                                std::size_t together);

  std::string path_;  ///< of the journal of the run, that of process 0
  std::uint64_t kind_ = 0;
  std::string instruction_set_;
  Team* team_ = nullptr;
  std::optional<ShardOfRun> shard_;
  std::unordered_map<std::string, std::vector<std::byte>> found_;
  std::unordered_set<std::string> gathered_;  ///< ids of those that other processes have kept
  std::optional<ShardMark> found_shard_;      ///< what the file that was found is a shard of
  std::optional<ShardMark> merged_;           ///< of the run whose shards have all cases
  bool shard_ended_ = false;
  std::optional<Journal> journal_;
  std::uint64_t dropped_bytes_ = 0;
  std::size_t damaged_ = 0;
  std::string other_instruction_set_;
  int resumptions_ = 0;
  std::atomic<bool> empty_ = true;
};

}  // namespace plastica::io
