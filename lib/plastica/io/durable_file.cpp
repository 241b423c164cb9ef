#include "plastica/io/durable_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace plastica::io {
namespace {

std::string system_error(std::string_view action) {
  return std::string(action) + ": " + std::strerror(errno);
}

}  // namespace

void sync_to_disk(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw StorageError(path, system_error("cannot be opened"));
  const bool done = ::fsync(descriptor) == 0;
  const int error = errno;
  ::close(descriptor);
  // Some file systems know no fsync of folders.
  if (!done && error != EINVAL) {
    errno = error;
    throw StorageError(path, system_error("cannot be forced to the disk"));
  }
}

std::string folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace plastica::io
