#include "plastica/io/png_resolution.hpp"

#include <libdeflate.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "plastica/base/machine_error.hpp"

namespace plastica::io {
namespace {

// Chunks are a length, a name of four letters, data and a check sum; the first is IHDR, with 13
// bytes of data.
constexpr std::size_t kSignature = 8;
constexpr std::size_t kAroundData = 12;
constexpr std::size_t kHeader = kAroundData + 13;

/// The highest byte first.
void append(std::string& bytes, std::uint32_t number) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>((number >> shift) & 0xFFU);
}

}  // namespace

void set_png_resolution(std::string& png, double dots_per_inch) {
  using namespace std::string_view_literals;
  const std::string_view all = png;
  const bool is_png = all.size() > kSignature + kHeader && all.starts_with("\x89PNG\r\n\x1A\n"sv) &&
                      all.substr(kSignature + 4, 4) == "IHDR";
  if (!is_png) throw MachineError("gnuplot's PNG does not begin as a PNG does");
  constexpr double kMetresPerInch = 0.0254;
  const auto dots = static_cast<std::uint32_t>(std::lround(dots_per_inch / kMetresPerInch));
  std::string body = "pHYs";  // dots per metre across and down, and that a metre is meant
  append(body, dots);
  append(body, dots);
  body += '\1';
  std::string chunk;
  append(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  append(chunk, libdeflate_crc32(0, body.data(), body.size()));
  png.insert(kSignature + kHeader, chunk);
}

}  // namespace plastica::io
