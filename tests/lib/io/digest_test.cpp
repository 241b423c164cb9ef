#include "plastica/io/digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
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

std::uint64_t xxh3_of(std::string_view text) { return xxh3(std::as_bytes(std::span(text))); }

TEST(Digest, GivesThePublishedValuesOfXxh3) {
  EXPECT_EQ(xxh3_of(""), 0x2d06800538d394c2U);
  EXPECT_EQ(xxh3_of("abc"), 0x78af5f94892f3950U);
}

TEST(Digest, OfPiecesIsThatOfTheWhole) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += std::to_string(i);
  for (const std::size_t piece : {1U, 7U, 1000U}) {
    Xxh3 pieces;
    for (std::size_t at = 0; at < text.size(); at += piece) {
      pieces.bytes(std::as_bytes(std::span(std::string_view(text).substr(at, piece))));
    }
    EXPECT_EQ(pieces.value(), xxh3_of(text)) << piece;
  }
}

TEST(Digest, OfManyNumbersFindsEachThatChanges) {
  std::vector<double> values(1000, 0.1);
  const std::uint64_t whole = Digest().reals(values).value();
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{255}, std::size_t{256}, values.size() - 1}) {
    values[i] = -values[i];
    EXPECT_NE(Digest().reals(values).value(), whole) << i;
    values[i] = -values[i];
  }
  values[300] = 0.0;
  const std::uint64_t with_zero = Digest().reals(values).value();
  values[300] = -0.0;
  EXPECT_EQ(Digest().reals(values).value(), with_zero);
}

}  // namespace
}  // namespace plastica::io
