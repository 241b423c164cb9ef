#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"

namespace plastica::calibrate {

/// Version of the records below: to be raised whenever a field of a result is added, removed or
/// moved. Records of another version are refused.
inline constexpr std::uint32_t kSceneResultVersion = 7;

/// A result of a fit through scenes as bytes, with every field: what the journal keeps of it.
std::vector<std::byte> bytes_of(const SceneFitResult& result);
/// The result that `bytes_of` was given, bit by bit.
/// @throws io::StorageError if the bytes are torn or of another version
SceneFitResult scene_result_from_bytes(std::span<const std::byte> bytes);

}  // namespace plastica::calibrate
