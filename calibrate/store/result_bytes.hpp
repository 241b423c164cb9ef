#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_result.hpp"

namespace plastica::calibrate {

/// Version of the records below: to be raised whenever a field of a result is added, removed or
/// moved, or fits get other numbers, however little. Records of another version are refused.
inline constexpr std::uint32_t kResultVersion = 18;

/// A result as bytes, with every field: what the journal keeps of a finished fit.
std::vector<std::byte> bytes_of(const FitResult& result);
std::vector<std::byte> bytes_of(const SceneFitResult& result);

/// The result that `bytes_of` was given, bit by bit.
/// @tparam Result  FitResult or SceneFitResult
/// @throws io::StorageError if the bytes are torn or of another version
template <typename Result>
Result result_from_bytes(std::span<const std::byte> bytes);

}  // namespace plastica::calibrate
