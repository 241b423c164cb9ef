#include "plastica/io/png_resolution.hpp"

#include <gtest/gtest.h>

#include <string>

#include "plastica/base/machine_error.hpp"

namespace plastica::io {
namespace {

using namespace std::string_literals;

/// A PNG of one dot up to its first data, which are not looked at.
std::string begin_of_png() {
  return "\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\10\2\0\0\0\x90wS\xDE"s + "\0\0\0\14IDAT"s;
}

TEST(PngResolution, StandsBehindTheHeader) {
  std::string png = begin_of_png();
  set_png_resolution(png, 300.0);
  // 11811 dots in a metre; the check sum as Python's zlib.crc32 has it.
  const std::string chunk = "\0\0\0\tpHYs\0\0.#\0\0.#\1"s + "\x78\xA5\x3F\x76"s;
  EXPECT_EQ(png, begin_of_png().insert(33, chunk));
}

TEST(PngResolution, IsRefusedForOtherFiles) {
  std::string text(100, 'x');
  EXPECT_THROW(set_png_resolution(text, 300.0), MachineError);
  std::string cut = begin_of_png().substr(0, 20);
  EXPECT_THROW(set_png_resolution(cut, 300.0), MachineError);
}

}  // namespace
}  // namespace plastica::io
