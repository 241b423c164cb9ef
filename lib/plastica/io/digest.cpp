#include "plastica/io/digest.hpp"

#define XXH_INLINE_ALL  // no library to link
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace plastica::io {
namespace {

constexpr std::uint64_t kPrime = 0x100000001b3U;

std::uint64_t fed(std::uint64_t state, std::uint64_t byte) { return (state ^ byte) * kPrime; }

/// Equal for all that are equal.
std::uint64_t bits_of(double value) {
  constexpr std::uint64_t kNaN = 0x7ff8000000000000U;
  if (std::isnan(value)) return kNaN;
  return std::bit_cast<std::uint64_t>(value == 0.0 ? 0.0 : value);
}

}  // namespace

Digest& Digest::bytes(std::span<const std::byte> data) {
  for (const std::byte byte : data) state_ = fed(state_, std::to_integer<std::uint64_t>(byte));
  return *this;
}

Digest& Digest::block(std::span<const std::byte> data) {
  return integer(data.size()).integer(xxh3(data));
}

Digest& Digest::text(std::string_view value) {
  integer(value.size());
  return bytes(std::as_bytes(std::span(value)));
}

Digest& Digest::integer(std::uint64_t value) {
  for (unsigned shift = 0; shift < 64; shift += 8) state_ = fed(state_, (value >> shift) & 0xFFU);
  return *this;
}

Digest& Digest::real(double value) { return integer(bits_of(value)); }

Digest& Digest::reals(std::span<const double> values) {
  integer(values.size());
  std::array<std::uint64_t, 256> bits{};
  while (!values.empty()) {
    const std::size_t count = std::min(values.size(), bits.size());
    std::ranges::transform(values.first(count), bits.begin(), bits_of);
    integer(xxh3(std::as_bytes(std::span(bits).first(count))));
    values = values.subspan(count);
  }
  return *this;
}

std::uint64_t xxh3(std::span<const std::byte> data) {
  return XXH3_64bits(data.data(), data.size());
}

struct Xxh3::State {
  XXH3_state_t of_library;
};

Xxh3::Xxh3() : state_(std::make_unique<State>()) { XXH3_64bits_reset(&state_->of_library); }

Xxh3::~Xxh3() = default;

void Xxh3::bytes(std::span<const std::byte> data) {
  XXH3_64bits_update(&state_->of_library, data.data(), data.size());
}

std::uint64_t Xxh3::value() const { return XXH3_64bits_digest(&state_->of_library); }

std::string hexadecimal(std::uint64_t digest) {
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) {
    text[i] = "0123456789abcdef"[(digest >> (60 - 4 * i)) & 0xFU];
  }
  return text;
}

}  // namespace plastica::io
