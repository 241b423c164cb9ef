#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "calibrate/result/result.hpp"
#include "plastica/io/bytes.hpp"

namespace plastica::calibrate {

/// Version of the records below: to be raised whenever a field of a target or a result is added,
/// removed or moved. Records of another version are refused.
inline constexpr std::uint32_t kRecordVersion = 11;

/// A result as bytes, with every field: what the journal keeps of a finished fit.
std::vector<std::byte> bytes_of(const FitResult& result);
/// The result that `bytes_of` was given, bit by bit.
/// @throws io::StorageError if the bytes are torn or of another version
FitResult result_from_bytes(std::span<const std::byte> bytes);

/// A target and its result as bytes, with every field.
std::vector<std::byte> bytes_of(const FitRecord& record);
/// The record that `bytes_of` was given, bit by bit.
/// @throws io::StorageError if the bytes are torn or of another version
FitRecord record_from_bytes(std::span<const std::byte> bytes);

/// Adds those parts of a target that can decide its fit: name, test, measure, loading, status,
/// corrected curve, characteristics and properties (its strain rate is one). Where it comes from,
/// its raw curve, what was repaired and to which group it belongs can change without changing the
/// fit.
void put_deciding_parts(io::ByteWriter& writer, const Target& target);

}  // namespace plastica::calibrate
