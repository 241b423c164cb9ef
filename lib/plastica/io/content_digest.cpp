#include "plastica/io/content_digest.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/digest.hpp"
#include "plastica/io/file_descriptor.hpp"
#include "plastica/io/storage_error.hpp"

namespace plastica::io {
namespace {

constexpr std::string_view kHdf5Signature = "\211HDF\r\n\032\n";
constexpr std::string_view kTitle = "Plastica result; HDF5 from byte 512 on\n";

/// Which digest of a content its block says: older files have that of FNV-1a.
enum class DigestKind { Fnv1a, Xxh3 };

std::string_view word_of(DigestKind kind) { return kind == DigestKind::Xxh3 ? "xxh3 " : "digest "; }

/// The block in front of a content.
std::string block_of(std::uint64_t bytes, DigestKind kind, std::uint64_t digest) {
  std::string block(kTitle);
  block += "bytes " + std::to_string(bytes) + "\n";
  block += std::string(word_of(kind)) + hexadecimal(digest) + "\n";
  block.resize(kContentOffset, '\0');
  return block;
}

/// Reads until the buffer is full or the file ends. @return the bytes read; -1 for an error
ssize_t read_at(int descriptor, std::span<std::byte> buffer, std::size_t offset) {
  std::size_t filled = 0;
  while (filled < buffer.size()) {
    const ssize_t got = ::pread(descriptor, buffer.data() + filled, buffer.size() - filled,
                                static_cast<off_t>(offset + filled));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return -1;
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
  }
  return static_cast<ssize_t>(filled);
}

/// Reads all that stands behind the block.
/// @return the block that such a content has; empty for an error: `errno` says which
std::string read_content(int descriptor, DigestKind kind, std::uint64_t& bytes) {
  std::vector<std::byte> buffer(std::size_t{1} << 18U);
  Xxh3 xxh3;
  Digest fnv1a;
  bytes = 0;
  while (true) {
    const ssize_t got = read_at(descriptor, buffer, kContentOffset + bytes);
    if (got < 0) return {};
    if (got == 0) break;
    const auto read = std::span<const std::byte>(buffer).first(static_cast<std::size_t>(got));
    kind == DigestKind::Xxh3 ? xxh3.bytes(read) : void(fnv1a.bytes(read));
    bytes += static_cast<std::uint64_t>(got);
  }
  return block_of(bytes, kind, kind == DigestKind::Xxh3 ? xxh3.value() : fnv1a.value());
}

/// The number behind "bytes " in a block; 0 if there is none.
std::uint64_t bytes_said(std::string_view block) {
  std::uint64_t bytes = 0;
  block.remove_prefix(kTitle.size());
  constexpr std::string_view kBefore = "bytes ";
  if (!block.starts_with(kBefore)) return 0;
  for (const char c : block.substr(kBefore.size(), 18)) {
    if (c < '0' || c > '9') break;
    bytes = 10 * bytes + static_cast<std::uint64_t>(c - '0');
  }
  return bytes;
}

/// The first bytes of a regular file, as many as a title has; empty of what cannot be read.
std::string beginning_of(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  std::array<std::byte, kTitle.size()> buffer{};
  if (file.get() < 0) return {};
  const ssize_t got = read_at(file.get(), buffer, 0);
  if (got <= 0) return {};
  return {reinterpret_cast<const char*>(buffer.data()), static_cast<std::size_t>(got)};
}

}  // namespace

void write_content_digest(int descriptor, const std::string& path) {
  const auto fail = [&](const char* action) {
    throw StorageError(path, std::string(action) + ": " + std::strerror(errno));
  };
  std::uint64_t bytes = 0;
  const std::string block = read_content(descriptor, DigestKind::Xxh3, bytes);
  if (block.empty()) fail("cannot be read back");
  std::size_t done = 0;
  while (done < block.size()) {
    const ssize_t written =
        ::pwrite(descriptor, block.data() + done, block.size() - done, static_cast<off_t>(done));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot be written");
    done += static_cast<std::size_t>(written);
  }
}

bool begins_with_digest(const std::string& path) { return beginning_of(path).starts_with(kTitle); }

bool begins_as_result(const std::string& path) {
  const std::string begin = beginning_of(path);
  return begin.starts_with(kTitle) || begin.starts_with(kHdf5Signature);
}

bool check_content_digest(const std::string& path) {
  const auto refuse = [&](const std::string& rule) { throw InputError({path, 0}, "", "", rule); };
  const auto refuse_unread = [&] {
    refuse(std::string("cannot be read: ") + std::strerror(errno));
  };
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) refuse_unread();
  if (S_ISDIR(status.st_mode)) refuse("cannot be read: it is a folder");
  if (!S_ISREG(status.st_mode)) refuse("is no regular file");

  std::array<std::byte, kContentOffset> buffer{};
  const ssize_t got = read_at(file.get(), buffer, 0);
  if (got < 0) refuse_unread();
  const std::string_view block(reinterpret_cast<const char*>(buffer.data()),
                               static_cast<std::size_t>(got));
  if (block.starts_with(kHdf5Signature)) return false;
  if (!block.starts_with(kTitle)) {
    std::array<std::byte, kHdf5Signature.size()> behind{};
    const bool hdf5 = read_at(file.get(), behind, kContentOffset) == ssize_t(behind.size()) &&
                      std::memcmp(behind.data(), kHdf5Signature.data(), behind.size()) == 0;
    refuse(hdf5 ? "is damaged: what stands in front of its HDF5 part is not what Plastica writes"
                : "is not an HDF5 file");
  }
  const bool is_older = block.find(word_of(DigestKind::Fnv1a)) != std::string_view::npos;
  std::uint64_t bytes = 0;
  const std::string expected =
      read_content(file.get(), is_older ? DigestKind::Fnv1a : DigestKind::Xxh3, bytes);
  if (expected.empty()) refuse_unread();
  const std::uint64_t said = bytes_said(block);
  if (bytes < said) {
    refuse("is cut off: of " + std::to_string(kContentOffset + said) + " bytes " +
           std::to_string(kContentOffset + bytes) + " are left");
  }
  if (block != expected) {
    refuse("is damaged, or was changed by another program: it differs from its digest");
  }
  return true;
}

}  // namespace plastica::io
