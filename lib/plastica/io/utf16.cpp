#include "plastica/io/utf16.hpp"

#include <cstddef>
#include <cstdint>

#include "plastica/base/check.hpp"

namespace plastica::io {
namespace {

void append_utf8(std::uint32_t code, std::string& text) {
  const auto put = [&](std::uint32_t byte) { text.push_back(static_cast<char>(byte)); };
  if (code < 0x80U) {
    put(code);
  } else if (code < 0x800U) {
    put(0xC0U | (code >> 6U));
    put(0x80U | (code & 0x3FU));
  } else if (code < 0x10000U) {
    put(0xE0U | (code >> 12U));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  } else {
    put(0xF0U | (code >> 18U));
    put(0x80U | ((code >> 12U) & 0x3FU));
    put(0x80U | ((code >> 6U) & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

}  // namespace

std::optional<ByteOrder> utf16_order(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE")) return ByteOrder::LittleEndian;
  if (bytes.starts_with("\xFE\xFF")) return ByteOrder::BigEndian;
  if (bytes.size() < 4) return std::nullopt;
  const auto is_zero = [&](std::size_t i) { return bytes[i] == '\0'; };
  if (!is_zero(0) && is_zero(1) && !is_zero(2) && is_zero(3)) return ByteOrder::LittleEndian;
  if (is_zero(0) && !is_zero(1) && is_zero(2) && !is_zero(3)) return ByteOrder::BigEndian;
  return std::nullopt;
}

std::string utf8_of_utf16(std::string_view bytes, ByteOrder order, const std::string& file) {
  int line = 1;
  const auto refuse = [&](const char* rule) { throw InputError({file, line}, "", "", rule); };
  const std::size_t first = order == ByteOrder::LittleEndian ? 0 : 1;
  const auto unit = [&](std::size_t at) {
    const auto low = static_cast<unsigned char>(bytes[at + first]);
    const auto high = static_cast<unsigned char>(bytes[at + 1 - first]);
    return static_cast<std::uint32_t>(low) | (static_cast<std::uint32_t>(high) << 8U);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  const std::size_t end = bytes.size() - bytes.size() % 2;
  std::size_t at = end >= 2 && unit(0) == 0xFEFFU ? 2 : 0;
  for (; at < end; at += 2) {
    std::uint32_t code = unit(at);
    if (code == 0) refuse("is not text (it has a zero character)");
    if (code >= 0xD800U && code < 0xE000U) {
      const bool paired =
          code < 0xDC00U && at + 2 < end && unit(at + 2) >= 0xDC00U && unit(at + 2) < 0xE000U;
      if (!paired) refuse("is UTF-16 text with a broken character");
      code = 0x10000U + ((code - 0xD800U) << 10U) + (unit(at + 2) - 0xDC00U);
      at += 2;
    }
    line += code == '\n' ? 1 : 0;
    append_utf8(code, text);
  }
  if (end != bytes.size()) refuse("is UTF-16 text that ends amid a character");
  return text;
}

}  // namespace plastica::io
