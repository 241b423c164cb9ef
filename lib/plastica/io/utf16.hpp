#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plastica::io {

/// How two bytes make a unit of UTF-16.
enum class ByteOrder { LittleEndian, BigEndian };

/// The byte order of UTF-16 text, by its mark or, without one, by the zero bytes of its first two
/// characters, which are of ASCII in a table or a configuration; empty for any other bytes.
std::optional<ByteOrder> utf16_order(std::string_view bytes);

/// UTF-16 as UTF-8, without its mark.
/// @throws InputError for half a character, a surrogate without its other half, and a zero
/// character
std::string utf8_of_utf16(std::string_view bytes, ByteOrder order, const std::string& file);

}  // namespace plastica::io
