#include "plastica/io/digest.hpp"

#include <bit>
#include <cmath>

namespace plastica::io {
namespace {

constexpr std::uint64_t kPrime = 0x100000001b3U;

std::uint64_t fed(std::uint64_t state, std::uint64_t byte) { return (state ^ byte) * kPrime; }

}  // namespace

Digest& Digest::bytes(std::span<const std::byte> data) {
  for (const std::byte byte : data) state_ = fed(state_, std::to_integer<std::uint64_t>(byte));
  return *this;
}

Digest& Digest::text(std::string_view value) {
  integer(value.size());
  return bytes(std::as_bytes(std::span(value)));
}

Digest& Digest::integer(std::uint64_t value) {
  for (unsigned shift = 0; shift < 64; shift += 8) state_ = fed(state_, (value >> shift) & 0xFFU);
  return *this;
}

Digest& Digest::real(double value) {
  constexpr std::uint64_t kNaN = 0x7ff8000000000000U;
  if (std::isnan(value)) return integer(kNaN);
  return integer(std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value));
}

Digest& Digest::reals(std::span<const double> values) {
  integer(values.size());
  for (const double value : values) real(value);
  return *this;
}

std::string hexadecimal(std::uint64_t digest) {
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) {
    text[i] = "0123456789abcdef"[(digest >> (60 - 4 * i)) & 0xFU];
  }
  return text;
}

}  // namespace plastica::io
