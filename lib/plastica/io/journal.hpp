#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

/// What a journal's file begins with.
inline constexpr std::string_view kJournalMagic = "PLASTJNL";

/// A finished case: who it is and what came out.
struct JournalRecord {
  std::string id;
  std::vector<std::byte> payload;
};

/// What stands at a journal's path.
enum class JournalState {
  Absent,        ///< no file, or one that was cut off inside its header
  Usable,        ///< a journal of this run
  OtherRun,      ///< a journal of a run with other settings or inputs
  OtherVersion,  ///< a journal of another version of the format
  NotAJournal,   ///< some other file
  InUse,         ///< a journal that another run is writing
};

/// A journal as it was found.
struct JournalContent {
  JournalState state = JournalState::Absent;
  std::uint64_t run_digest = 0;        ///< of the run that wrote it
  std::vector<JournalRecord> records;  ///< all complete ones, in the order of writing; if `Usable`
  std::uint64_t complete_bytes = 0;    ///< up to the end of the last complete record
  std::uint64_t dropped_bytes = 0;     ///< behind it: a record torn by a crash
  std::size_t damaged = 0;             ///< stretches of bytes between complete records
};

/// Reads the records of a journal that are whole; what is damaged between them is left out.
/// @param run_digest  identifies what is computed: settings and inputs
/// @throws InputError if a link, folder, pipe or device stands there; StorageError if the file is
///         there but cannot be read
JournalContent read_journal(const std::string& path, std::uint64_t run_digest);
/// The same of whatever run, and through links: of a file that will not be written.
JournalContent read_any_journal(const std::string& path);

/// The same while another process of the run has it open, which writes no record meanwhile.
JournalContent read_open_journal(const std::string& path, std::uint64_t run_digest);

/// Whether another run is writing a journal. What cannot be looked at is in nobody's use.
bool is_in_use(const std::string& path);

/// An append-only file of finished cases beside an output, which survives `kill -9` at any byte.
///
/// Layout, little-endian: "PLASTJNL", version (8 bytes), run digest (8); then per record the
/// lengths of id and payload (8 each), a digest of both (8; `journal_layout::checksum_of`), id,
/// payload.
/// A record is handed to the system completely when `append` returns and is on the disk at most one
/// sync interval later. One process at a time may write a journal.
class Journal {
 public:
  static constexpr std::chrono::milliseconds kSyncInterval{500};

  /// Starts afresh, over whatever is at the path.
  /// @throws StorageError if it cannot be written or another process is writing it
  static Journal create(const std::string& path, std::uint64_t run_digest,
                        std::chrono::milliseconds sync_interval = kSyncInterval);
  /// Goes on behind the complete records of a journal; a torn one is cut off. If it is absent, it
  /// is created. @param content  as `read_journal` gave it; `Usable` or `Absent`
  /// @throws StorageError as above, or if the journal has changed since it was read
  static Journal resume(const std::string& path, std::uint64_t run_digest,
                        const JournalContent& content,
                        std::chrono::milliseconds sync_interval = kSyncInterval);

  /// Forces what is written to the disk, as far as that works, and closes.
  ~Journal();
  Journal(Journal&&) noexcept;
  Journal& operator=(Journal&&) noexcept;

  /// Adds a record; may be called by several threads.
  /// @throws StorageError if it, or an earlier sync, failed; the journal stays readable
  void append(std::string_view id, std::span<const std::byte> payload);

  /// Forces all records to the disk now. @throws StorageError
  void sync();
  /// Whether all records have been forced to the disk.
  bool synced() const;

  /// Deletes the file, if it is still there, and closes it: its content has gone into the output.
  /// No record may follow.
  /// @throws StorageError
  void remove();

 private:
  class Writer;
  explicit Journal(std::unique_ptr<Writer> writer);

  std::unique_ptr<Writer> writer_;
};

}  // namespace plastica::io
