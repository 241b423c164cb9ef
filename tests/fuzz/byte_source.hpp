#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

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

}  // namespace plastica::fuzz
