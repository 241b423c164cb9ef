#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "plastica/io/digest.hpp"

/// How a journal stands in its file, see journal.hpp; not installed.
namespace plastica::io::journal_layout {

inline constexpr std::uint64_t kVersion = 2;
inline constexpr std::size_t kHeaderBytes = 24;
inline constexpr std::size_t kRecordHeadBytes = 24;

inline std::uint64_t checksum_of(std::string_view id, std::span<const std::byte> payload) {
  return Digest().integer(id.size()).bytes(std::as_bytes(std::span(id))).block(payload).value();
}

}  // namespace plastica::io::journal_layout
