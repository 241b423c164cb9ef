#include "plastica/io/digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace plastica::io {
namespace {

std::uint64_t of_bytes(std::string_view text) {
  return Digest().bytes(std::as_bytes(std::span(text))).value();
}

TEST(Digest, GivesThePublishedValuesOfFnv1a) {
  EXPECT_EQ(of_bytes(""), 0xcbf29ce484222325U);
  EXPECT_EQ(of_bytes("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(of_bytes("foobar"), 0x85944171f73967e8U);
}

TEST(Digest, DoesNotDependOnHowBytesAreCut) {
  const std::string_view text = "0123456789";
  Digest pieces;
  for (const char& c : text) pieces.bytes(std::as_bytes(std::span(&c, 1)));
  EXPECT_EQ(pieces.value(), of_bytes(text));
}

TEST(Digest, TellsTextsApartThatJoinToTheSame) {
  EXPECT_NE(Digest().text("ab").text("c").value(), Digest().text("a").text("bc").value());
  EXPECT_NE(Digest().text("").text("a").value(), Digest().text("a").text("").value());
  const std::vector<double> one{1.0};
  const std::vector<double> two{2.0};
  EXPECT_NE(Digest().reals(one).reals(two).value(),
            Digest().reals(std::vector{1.0, 2.0}).reals({}).value());
}

TEST(Digest, TakesEqualNumbersForEqual) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Digest().real(0.0).value(), Digest().real(-0.0).value());
  EXPECT_EQ(Digest().real(kNaN).value(), Digest().real(-kNaN).value());
  EXPECT_NE(Digest().real(1.0).value(), Digest().real(std::nextafter(1.0, 2.0)).value());
}

TEST(Digest, IsShownAsSixteenHexadecimalDigits) {
  EXPECT_EQ(hexadecimal(0x0123456789abcdefU), "0123456789abcdef");
  EXPECT_EQ(hexadecimal(0), "0000000000000000");
}

}  // namespace
}  // namespace plastica::io
