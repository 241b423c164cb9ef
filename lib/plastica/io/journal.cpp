#include "plastica/io/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "plastica/base/check.hpp"
#include "plastica/io/bytes.hpp"
#include "plastica/io/durable_file.hpp"
#include "plastica/io/file_descriptor.hpp"
#include "plastica/io/journal_layout.hpp"
#include "plastica/io/output_file.hpp"

namespace plastica::io {
namespace {

using journal_layout::checksum_of;
using journal_layout::kVersion;

constexpr const char* kInUse = "is in use by another run";

[[noreturn]] void fail(const std::string& path, const std::string& action) {
  throw StorageError(path, action + ": " + std::strerror(errno));
}

/// False if the disk does not take it all; `errno` says why.
bool write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

std::vector<std::byte> header_of(std::uint64_t run_digest) {
  ByteWriter writer;
  for (const char c : kJournalMagic) writer.put(c);
  writer.put(kVersion).put(run_digest);
  return writer.take();
}

}  // namespace

/// The open file, and the thread that forces it to the disk now and then.
class Journal::Writer {
 public:
  /// Opens the file and keeps its first `keep` bytes; with none, it begins with a header.
  Writer(const std::string& path, std::uint64_t run_digest, std::uint64_t keep,
         const std::uint64_t* expected_bytes, std::chrono::milliseconds sync_interval)
      : path_(path),
        file_(::open(path.c_str(),
                     O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666)),
        sync_interval_(sync_interval) {
    if (file_.get() < 0) fail(path_, "cannot be written");
    const bool locked = ::flock(file_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    // A run that has just ended has removed it between our opening and locking it.
    if (!locked || !is_named(file_.get(), path_)) throw StorageError(path_, kInUse);
    struct stat status {};
    if (::fstat(file_.get(), &status) != 0) fail(path_, "cannot be written");
    if (expected_bytes != nullptr &&
        static_cast<std::uint64_t>(status.st_size) != *expected_bytes) {
      throw StorageError(path_, "has changed while it was read");
    }
    complete_bytes_ = keep;
    cut();
    if (keep == 0) {
      const std::vector<std::byte> header = header_of(run_digest);
      if (!write_all(file_.get(), header)) fail(path_, "cannot be written");
      complete_bytes_ = header.size();
    }
    if (::fsync(file_.get()) != 0) fail(path_, "cannot be forced to the disk");
    sync_to_disk(folder_of(path_));
    syncer_ = std::thread([this] { keep_syncing(); });
  }

  ~Writer() { close(); }

  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void append(std::string_view id, std::span<const std::byte> payload) {
    std::vector<std::byte> record;
    {
      ByteWriter head;
      head.put(std::uint64_t{id.size()}).put(std::uint64_t{payload.size()});
      head.put(checksum_of(id, payload));
      record = head.take();
      const auto id_bytes = std::as_bytes(std::span(id));
      record.insert(record.end(), id_bytes.begin(), id_bytes.end());
      record.insert(record.end(), payload.begin(), payload.end());
    }
    const std::lock_guard lock(mutex_);
    throw_if_failed();
    if (!write_all(file_.get(), record)) {
      const int error = errno;
      cut();  // later records must not stand behind half a one
      errno = error;
      fail(path_, "cannot be written");
    }
    complete_bytes_ += record.size();
    dirty_ = true;
  }

  void sync() {
    const std::lock_guard lock(mutex_);
    throw_if_failed();
    if ((dirty_ || syncing_) && ::fsync(file_.get()) != 0)
      fail(path_, "cannot be forced to the disk");
    dirty_ = false;
  }

  bool synced() const {
    const std::lock_guard lock(mutex_);
    return !dirty_ && !syncing_;
  }

  void remove() {
    // While it is locked: afterwards another run may have begun a journal under this name.
    const bool ours = is_named(file_.get(), path_);
    const bool removed = !ours || ::unlink(path_.c_str()) == 0;
    const int error = errno;
    close();
    errno = error;
    if (!removed) fail(path_, "cannot be removed");
  }

 private:
  void cut() {
    if (::ftruncate(file_.get(), static_cast<off_t>(complete_bytes_)) != 0) {
      fail(path_, "cannot be cut to its complete records");
    }
  }

  void throw_if_failed() const {
    if (sync_error_ == 0) return;
    errno = sync_error_;
    fail(path_, "cannot be forced to the disk");
  }

  void keep_syncing() {
    std::unique_lock lock(mutex_);
    while (!closing_.wait_for(lock, sync_interval_, [this] { return closed_; })) {
      if (!dirty_) continue;
      dirty_ = false;
      syncing_ = true;
      lock.unlock();  // appending must not wait for the disk
      const int error = ::fsync(file_.get()) != 0 ? errno : 0;
      lock.lock();
      syncing_ = false;
      if (error != 0) {
        sync_error_ = error;
        dirty_ = true;
      }
    }
  }

  void close() {
    {
      const std::lock_guard lock(mutex_);
      if (closed_) return;
      closed_ = true;
    }
    closing_.notify_all();
    syncer_.join();
    if (dirty_) ::fsync(file_.get());
  }

  std::string path_;
  FileDescriptor file_;
  std::chrono::milliseconds sync_interval_;
  mutable std::mutex mutex_;
  std::condition_variable closing_;
  std::uint64_t complete_bytes_ = 0;
  bool dirty_ = false;    // something was written since the last sync began
  bool syncing_ = false;  // the thread is at it
  bool closed_ = false;
  int sync_error_ = 0;  // errno of a sync that failed between two records
  std::thread syncer_;
};

Journal::Journal(std::unique_ptr<Writer> writer) : writer_(std::move(writer)) {}
Journal::~Journal() = default;
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&&) noexcept = default;

Journal Journal::create(const std::string& path, std::uint64_t run_digest,
                        std::chrono::milliseconds sync_interval) {
  return Journal(std::make_unique<Writer>(path, run_digest, 0, nullptr, sync_interval));
}

Journal Journal::resume(const std::string& path, std::uint64_t run_digest,
                        const JournalContent& content, std::chrono::milliseconds sync_interval) {
  const bool of_this_run =
      content.state == JournalState::Usable && content.run_digest == run_digest;
  if (!of_this_run && content.state != JournalState::Absent) {
    throw std::logic_error("Journal::resume: not a journal of this run");
  }
  const std::uint64_t expected = content.complete_bytes + content.dropped_bytes;
  return Journal(
      std::make_unique<Writer>(path, run_digest, content.complete_bytes, &expected, sync_interval));
}

void Journal::append(std::string_view id, std::span<const std::byte> payload) {
  writer_->append(id, payload);
}
void Journal::sync() { writer_->sync(); }
bool Journal::synced() const { return writer_->synced(); }
void Journal::remove() { writer_->remove(); }

}  // namespace plastica::io
