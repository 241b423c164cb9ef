#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>

#include "plastica/io/toml.hpp"
#include "plastica/io/toml_edit.hpp"

namespace plastica::io {
namespace {

constexpr std::array<std::string_view, 48> kPieces{"a",
                                                   "b",
                                                   "a.b",
                                                   "\"c\"",
                                                   "'d'",
                                                   ".",
                                                   " = ",
                                                   "=",
                                                   " = ",
                                                   "1",
                                                   "-2.5",
                                                   "1e3",
                                                   "nan",
                                                   "true",
                                                   "\"x\"",
                                                   "'y'",
                                                   "[",
                                                   "]",
                                                   "[",
                                                   "]",
                                                   "[[",
                                                   "]]",
                                                   "{",
                                                   "}",
                                                   ",",
                                                   ", ",
                                                   "\n",
                                                   "\n",
                                                   "\n",
                                                   "\n",
                                                   "\r\n",
                                                   "# c\n",
                                                   "\"\"\"",
                                                   "'''",
                                                   "\"",
                                                   "'",
                                                   "\\",
                                                   "\\u0041",
                                                   "\xC3\xB5",
                                                   "\t",
                                                   " ",
                                                   "1979-05-27",
                                                   "\xEF\xBB\xBF",
                                                   "\xFF",
                                                   "[a]\n",
                                                   "[[t]]\n",
                                                   "b = 1\n",
                                                   "a = [1, 2]\n"};

/// Asks for all that a value has.
void read_all(const TomlValue& value) {
  EXPECT_GT(value.where().line, 0);
  EXPECT_FALSE(value.key().empty());
  if (value.is_array()) {
    for (const TomlValue& item : value.array()) read_all(item);
  } else if (value.is_table()) {
    for (const std::string& key : value.table().keys()) read_all(value.table().at(key));
    value.table().check_unused();
  } else {
    EXPECT_FALSE(value.written().empty());
  }
}

TEST(TomlRandom, EveryTextIsReadOrRefusedInOneLine) {
  std::mt19937 random(1);
  const auto draw = [&](std::size_t below) { return random() % below; };
  std::size_t read = 0;
  constexpr std::size_t kTexts = 10'000;
  for (std::size_t i = 0; i < kTexts; ++i) {
    std::string text;
    for (std::size_t left = draw(10); left > 0; --left) {
      // Half of the lines are keys with some value.
      if (draw(2) == 0) text += std::string(1, static_cast<char>('e' + draw(20))) + " = ";
      for (std::size_t pieces = draw(4); pieces > 0; --pieces)
        text += kPieces[draw(kPieces.size())];
      if (draw(2) == 0) text += "\n";
    }
    try {
      const TomlTable root = TomlDocument::parse(text, "random.toml").root();
      ++read;
      for (const std::string& key : root.keys()) read_all(root.at(key));
      const std::string edited = set_toml_value(text, "a.b", "7");
      EXPECT_EQ(TomlDocument::parse(edited, "edited").root().at("a").table().at("b").written(),
                "7");
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    if (::testing::Test::HasFailure()) FAIL() << ::testing::PrintToString(text);
  }
  EXPECT_GT(read, kTexts / 20);
  EXPECT_LT(read, kTexts * 9 / 10);
}

}  // namespace
}  // namespace plastica::io
