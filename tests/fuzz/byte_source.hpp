#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {

/// Takes numbers and pieces from the front of fuzzed bytes; zeros and nothing where they end.
class ByteSource {
 public:
  explicit ByteSource(Bytes bytes) : bytes_(bytes) {}

  bool is_empty() const { return bytes_.empty(); }
  std::size_t byte() {
    if (bytes_.empty()) return 0;
    const std::size_t value = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return value;
  }
  /// A number of so many bytes, the lowest first.
  std::size_t number(int bytes) {
    std::size_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= byte() << (8 * i);
    return value;
  }
  Bytes piece(std::size_t size) {
    const Bytes taken = bytes_.first(std::min(size, bytes_.size()));
    bytes_ = bytes_.subspan(taken.size());
    return taken;
  }

 private:
  Bytes bytes_;
};

/// What is left of a file after patches: each the place in three bytes, the number of bytes in one,
/// these. Of 31 bytes or more there is none: the file ends there.
/// @param begin  the first byte that a patch may reach
inline std::string patched(std::string file, std::size_t begin, ByteSource patches) {
  while (!patches.is_empty() && file.size() > begin) {
    const std::size_t place = begin + patches.number(3) % (file.size() - begin);
    const std::size_t size = patches.byte();
    if (size > 30) {
      file.resize(place);
      continue;
    }
    const Bytes patch = patches.piece(std::min(size, file.size() - place));
    std::ranges::copy(patch, file.begin() + static_cast<std::ptrdiff_t>(place));
  }
  return file;
}

}  // namespace plastica::fuzz
