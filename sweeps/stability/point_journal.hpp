#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "plastica/io/case_journal.hpp"
#include "plastica/model/field.hpp"

namespace plastica::sweeps::stability {

struct JudgedRun;

/// The judged points of a scan of a user's scene: each goes to a journal, so that a scan survives
/// its interruption, and several processes may do one together.
class PointJournal {
 public:
  /// Reads the journal, if one is there, and opens it for writing.
  /// @param setup   the scene as it is
  /// @param within  see `SceneScanOptions`
  /// @throws InputError, io::StorageError as `io::CaseJournal`; InputError if the journal has
  ///         points, but none of this scene, and is not to be overwritten
  PointJournal(const io::JournalPolicy& policy, const Setup& setup, double within);

  /// How many points of the scene an earlier run has left.
  std::size_t resumed() const { return resumed_; }
  const io::CaseJournal& journal() const { return journal_; }
  /// The processes that do the scan together; null: there is one.
  Team* team() const { return team_; }

  /// What is known of a point: of an earlier run, of this one and, after `gather`, of other
  /// processes. May be called by several threads.
  std::optional<JudgedRun> find(const Setup& at) const;
  /// Keeps a point; may be called by several threads. @throws io::StorageError
  void keep(const Setup& at, const JudgedRun& run);
  /// Lets all processes know what each has kept. To be called by all of them, which keep nothing
  /// meanwhile. @throws io::StorageError, TeamLeft
  void gather() { journal_.gather(true); }
  /// Forces all points to the disk now. @throws io::StorageError
  void sync() { journal_.sync(); }
  /// Deletes the journal, once the points are stored, unless it has others, which nobody asked for.
  /// @return how many those are. @throws io::StorageError
  std::size_t finish();

 private:
  std::string id_of(const Setup& at) const;

  std::string run_;  ///< digest of what decides a point's verdict besides its setup
  Team* team_;
  io::CaseJournal journal_;
  std::size_t resumed_ = 0;
  mutable std::mutex mutex_;
  mutable std::unordered_set<std::string> asked_;                 ///< ids that were found or kept
  std::unordered_map<std::string, std::vector<std::byte>> kept_;  ///< by this process
};

}  // namespace plastica::sweeps::stability
