#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sweeps/run/case_result.hpp"

namespace plastica::sweeps {

/// Raised whenever what a journal's record holds changes.
inline constexpr std::uint64_t kResultVersion = 4;

/// A result as a record of a journal.
std::vector<std::byte> bytes_of(const CaseResult& result);
/// @throws io::StorageError if the record is none of this version
CaseResult result_from_bytes(std::span<const std::byte> bytes);

}  // namespace plastica::sweeps
