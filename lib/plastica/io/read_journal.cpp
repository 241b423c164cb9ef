#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>

#include "plastica/base/check.hpp"
#include "plastica/io/bytes.hpp"
#include "plastica/io/file_descriptor.hpp"
#include "plastica/io/journal.hpp"
#include "plastica/io/journal_layout.hpp"
#include "plastica/io/output_file.hpp"

namespace plastica::io {
namespace {

using journal_layout::kHeaderBytes;
using journal_layout::kRecordHeadBytes;

enum class Links { Refused, Followed };
enum class Locked { Refused, Read };

/// Refuses what is no file. @throws InputError
void check_place(const std::string& path, Links links) {
  const std::string special = special_file(path);
  if (special.empty()) return;
  std::error_code ignored;
  if (links == Links::Followed && std::filesystem::is_regular_file(path, ignored)) return;
  throw InputError(
      {path, 0}, "", "",
      links == Links::Followed
          ? "is " + special + ": must be a file"
          : "is " + special + " in the place of the journal: move it, or name another output");
}

/// All bytes of a file.
/// @return Absent if there is none; InUse if another run has it, and then nothing is read
JournalState read_all(const std::string& path, Links links, Locked locked,
                      std::vector<std::byte>& bytes) {
  check_place(path, links);
  const int no_links = links == Links::Refused ? O_NOFOLLOW : 0;
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | no_links | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) {
    if (errno == ENOENT) return JournalState::Absent;
    throw StorageError(path, std::string("cannot be read: ") + std::strerror(errno));
  }
  // Given back when the file is closed, before it is opened for writing.
  if (locked == Locked::Refused && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0 &&
      errno == EWOULDBLOCK) {
    return JournalState::InUse;
  }
  constexpr std::size_t kBlock = std::size_t{1} << 18U;
  std::size_t size = 0;
  while (true) {
    bytes.resize(size + kBlock);
    const ssize_t count = ::read(file.get(), bytes.data() + size, kBlock);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw StorageError(path, std::string("cannot be read: ") + std::strerror(errno));
    size += static_cast<std::size_t>(count);
    if (count == 0) break;
  }
  bytes.resize(size);
  return JournalState::Usable;
}

/// A record where it stands.
struct Found {
  std::string_view id;
  std::span<const std::byte> payload;
  std::size_t size = 0;  ///< with its head
};

std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// The record that bytes begin with; nothing if they begin with none, or one that is not whole.
/// @param checked  grows by the bytes that were read to tell
std::optional<Found> record_at(std::span<const std::byte> bytes, std::size_t& checked) {
  if (bytes.size() < kRecordHeadBytes) return {};
  const std::uint64_t id_bytes = number_at(bytes, 0);
  const std::uint64_t payload_bytes = number_at(bytes, 8);
  const std::uint64_t room = bytes.size() - kRecordHeadBytes;
  if (id_bytes > room || payload_bytes > room - id_bytes) return {};
  const auto id_part = bytes.subspan(kRecordHeadBytes, static_cast<std::size_t>(id_bytes));
  const auto payload =
      bytes.subspan(kRecordHeadBytes + id_part.size(), static_cast<std::size_t>(payload_bytes));
  const std::string_view id(reinterpret_cast<const char*>(id_part.data()), id_part.size());
  const std::size_t size = kRecordHeadBytes + id_part.size() + payload.size();
  checked += size;
  if (journal_layout::checksum_of(id, payload) != number_at(bytes, 16)) return {};
  return Found{id, payload, size};
}

/// Takes every record that is whole. Behind a damaged one the next is looked for at each byte, as
/// long as that does not read the file some twenty times: small numbers look like lengths.
void read_records(std::span<const std::byte> bytes, JournalContent& content) {
  const std::size_t most = 20 * bytes.size() + (std::size_t{1} << 24U);
  std::size_t checked = 0;
  std::size_t end = 0;  // of the last record
  for (std::size_t at = 0; at < bytes.size() && checked <= most;) {
    const std::optional<Found> found = record_at(bytes.subspan(at), checked);
    if (!found) {
      ++at;
      continue;
    }
    if (at > end) ++content.damaged;
    content.records.push_back(
        {std::string(found->id), {found->payload.begin(), found->payload.end()}});
    at += found->size;
    end = at;
  }
  content.complete_bytes += end;
  content.dropped_bytes = bytes.size() - end;
}

/// @param run_digest  empty: of whatever run
JournalContent read(const std::string& path, std::optional<std::uint64_t> run_digest, Links links,
                    Locked locked = Locked::Refused) {
  JournalContent content;
  std::vector<std::byte> bytes;
  content.state = read_all(path, links, locked, bytes);
  if (content.state != JournalState::Usable) return content;

  const std::size_t magic_bytes = std::min(bytes.size(), kJournalMagic.size());
  if (std::memcmp(bytes.data(), kJournalMagic.data(), magic_bytes) != 0) {
    content.state = JournalState::NotAJournal;
    return content;
  }
  if (bytes.size() < kHeaderBytes) {
    content.state = JournalState::Absent;
    content.dropped_bytes = bytes.size();
    return content;
  }
  const std::span<const std::byte> all = bytes;
  ByteReader header(all.subspan(kJournalMagic.size(), kHeaderBytes - kJournalMagic.size()), path);
  const auto version = header.get<std::uint64_t>();
  content.run_digest = header.get<std::uint64_t>();
  content.complete_bytes = kHeaderBytes;
  if (version != journal_layout::kVersion) {
    content.state = JournalState::OtherVersion;
    return content;
  }
  if (run_digest && content.run_digest != *run_digest) {
    content.state = JournalState::OtherRun;
    return content;
  }
  read_records(all.subspan(kHeaderBytes), content);
  return content;
}

}  // namespace

JournalContent read_journal(const std::string& path, std::uint64_t run_digest) {
  return read(path, run_digest, Links::Refused);
}

JournalContent read_open_journal(const std::string& path, std::uint64_t run_digest) {
  return read(path, run_digest, Links::Refused, Locked::Read);
}

bool is_in_use(const std::string& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  return file.get() >= 0 && ::flock(file.get(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

JournalContent read_any_journal(const std::string& path) { return read(path, {}, Links::Followed); }

}  // namespace plastica::io
