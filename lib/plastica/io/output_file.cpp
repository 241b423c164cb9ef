#include "plastica/io/output_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/io/durable_file.hpp"

namespace plastica::io {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& action, int error) {
  throw StorageError(path, action + ": " + std::strerror(error));
}

/// A name for the fresh file, which must not be longer than names may be.
std::string part_name(const std::string& path, int number) {
  constexpr std::size_t kLongestName = 255;  // NAME_MAX of Linux
  const std::string tail =
      "." + std::to_string(::getpid()) + "-" + std::to_string(number) + ".part";
  const std::size_t slash = path.rfind('/');
  const std::size_t name = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t room = kLongestName - tail.size();
  return path.substr(0, name) + path.substr(name, room) + tail;
}

/// Opens a file that was not there. @return -1 and `errno` if that fails
int open_fresh(const std::string& path, std::string& part) {
  constexpr int kTries = 10'000;  // as many are left by killed runs of the same number at most
  int descriptor = -1;
  for (int number = 0; descriptor < 0 && number < kTries; ++number) {
    part = part_name(path, number);
    descriptor = ::open(part.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno != EEXIST) break;
  }
  return descriptor;
}

/// Renames without replacing. @return 0, or the error: EEXIST if there is something
int rename_to_free_name(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // File systems that cannot do it in one step know links.
  if (::link(from.c_str(), to.c_str()) != 0) return errno;
  ::unlink(from.c_str());
  return 0;
}

}  // namespace

OutputFile::OutputFile(std::string path, Overwrite overwrite)
    : path_(std::move(path)), overwrite_(overwrite) {
  if (const std::string why = no_output_reason(path_); !why.empty()) throw StorageError(path_, why);
  descriptor_ = open_fresh(path_, part_);
  if (descriptor_ < 0) {
    part_.clear();
    fail(path_, "cannot be written", errno);
  }
  struct stat old {};
  if (::lstat(path_.c_str(), &old) == 0 && S_ISREG(old.st_mode)) {
    // Only root may give files away; to all others the new one belongs.
    if (::fchown(descriptor_, old.st_uid, old.st_gid) != 0) errno = 0;
    if (::fchmod(descriptor_, old.st_mode & 07777U) != 0) errno = 0;
  }
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!part_.empty()) ::unlink(part_.c_str());
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      part_(std::exchange(other.part_, {})),
      overwrite_(other.overwrite_),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

void OutputFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path_, "cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void OutputFile::commit() {
  if (::fsync(descriptor_) != 0 && errno != EINVAL) {
    fail(path_, "cannot be forced to the disk", errno);
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(path_, "cannot be written", errno);
  move_into_place();
  part_.clear();
  sync_to_disk(folder_of(path_));
}

void OutputFile::move_into_place() {
  if (const std::string why = no_output_reason(path_); !why.empty()) keep_part(why);
  const int error = overwrite_ == Overwrite::Refused ? rename_to_free_name(part_, path_)
                    : std::rename(part_.c_str(), path_.c_str()) != 0 ? errno
                                                                     : 0;
  if (error == EEXIST) keep_part("has appeared since the run began, and is left as it is");
  if (error != 0) keep_part(std::string("cannot be moved into place: ") + std::strerror(error));
}

void OutputFile::keep_part(const std::string& why) {
  const std::string kept = std::exchange(part_, {});
  throw StorageError(path_, why + "; the result is kept as " + kept);
}

std::string special_file(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return "";
  switch (status.st_mode & S_IFMT) {
    case S_IFREG: return "";
    case S_IFDIR: return "a folder";
    case S_IFLNK: return "a link";
    case S_IFIFO: return "a named pipe";
    case S_IFSOCK: return "a socket";
    default: return "a device";
  }
}

std::string no_output_reason(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 && errno != ENOENT) {
    return std::string("cannot be written: ") + std::strerror(errno);
  }
  const std::string special = special_file(path);
  if (special.empty()) return "";
  if (special == "a link") return "is a link: name the file that it leads to";
  return "cannot be written: it is " + special;
}

bool is_named(int descriptor, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

std::string lock_path(const std::string& output) { return output + ".lock"; }

OutputLock::OutputLock(const std::string& output) : path_(lock_path(output)) {
  const auto refuse = [&](const std::string& what) {
    throw InputError({path_, 0}, "", "",
                     "is " + what + " in the place of the lock: move it, or name another output");
  };
  if (const std::string special = special_file(path_); !special.empty()) refuse(special);
  // Who had the lock before may have removed the file between our opening and locking it; not
  // over and over.
  constexpr int kTries = 100;
  for (int i = 0; i < kTries && descriptor_ < 0; ++i) {
    const int file =
        ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (file < 0) fail(path_, "cannot be written", errno);
    struct stat status {};
    const bool taken = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    const bool ours = ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size == 0;
    if (!taken && ours && is_named(file, path_)) {
      descriptor_ = file;
      return;
    }
    ::close(file);
    if (taken) break;
    if (!ours) refuse("a file of another kind");
  }
  throw StorageError(output, "is in use by another run");
}

OutputLock::~OutputLock() {
  // While it is locked, and only if it is still ours.
  if (is_named(descriptor_, path_)) ::unlink(path_.c_str());
  ::close(descriptor_);
}

}  // namespace plastica::io
