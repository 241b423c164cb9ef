#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/csv.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::io {
namespace {

/// What decides how a text is read; what is listed twice comes twice as often.
constexpr std::array<std::string_view, 56> kPieces{"\"",
                                                   "\"",
                                                   "\"\"",
                                                   ",",
                                                   ",",
                                                   ";",
                                                   ";",
                                                   "\t",
                                                   "\n",
                                                   "\n",
                                                   "\n",
                                                   "\r\n",
                                                   "\r",
                                                   " ",
                                                   "  ",
                                                   "0",
                                                   "1",
                                                   "2",
                                                   "7",
                                                   "9",
                                                   ".",
                                                   ",",
                                                   "e",
                                                   "E",
                                                   "-",
                                                   "+",
                                                   "[",
                                                   "]",
                                                   "(",
                                                   ")",
                                                   "{",
                                                   "}",
                                                   "#",
                                                   "/",
                                                   "a",
                                                   "Zug",
                                                   "nan",
                                                   "1,5",
                                                   "2.5",
                                                   "3e4",
                                                   "1e99",
                                                   "1e999",
                                                   "N/A",
                                                   "MPa",
                                                   " in mm",
                                                   "Stress",
                                                   "(%)",
                                                   "[kN]",
                                                   "\xC3\xA9",
                                                   "\xE9",
                                                   "\x80",
                                                   "\xFF",
                                                   "\xEF\xBB\xBF",
                                                   "1;2;3\n",
                                                   "1,2,3\n",
                                                   "a,b\n1,2\n"};

/// Texts that are the same in every run, of a few to some hundred characters.
class Texts {
 public:
  std::string next() {
    std::string text;
    const std::size_t pieces = draw(draw(10) == 0 ? 120 : 16);
    for (std::size_t i = 0; i < pieces; ++i) text += kPieces[draw(kPieces.size())];
    return text;
  }

  CsvOptions next_options() {
    CsvOptions options;
    if (draw(3) == 0) options.separator = std::string_view(",;\t")[draw(3)];
    if (draw(3) == 0) options.decimal = std::string_view(".,")[draw(2)];
    if (draw(3) == 0) options.header = draw(5);
    return options;
  }

  std::size_t draw(std::size_t below) { return random_() % below; }

 private:
  std::mt19937 random_{2};
};

/// Asks a table for all that it has.
void read_all(const CsvTable& table) {
  ASSERT_GT(table.rows(), 0U);
  ASSERT_GT(table.columns(), 0U);
  ASSERT_EQ(table.units().size(), table.columns());
  std::size_t characters = 0;
  for (std::size_t column = 0; column < table.columns(); ++column) {
    for (std::size_t row = 0; row < table.rows(); ++row) {
      for (const char c : table.cell(row, column)) characters += c == '\0' ? 0U : 1U;
      try {
        (void)table.number(row, column);
      } catch (const InputError& error) {
        EXPECT_EQ(error.where().line, table.line_of_row(row));
      }
    }
    for (const std::string& name : {table.names()[column], std::to_string(column + 1)}) {
      try {
        EXPECT_LT(table.find(name, {}, "column"), table.columns());
      } catch (const InputError& error) {
        EXPECT_EQ(error.field(), "column");
      }
    }
  }
  EXPECT_LT(characters, 4000U);
}

TEST(CsvRandom, EveryTextIsReadOrRefused) {
  Texts texts;
  std::size_t read = 0;
  constexpr std::size_t kTexts = testing::kSanitized ? 5'000 : 20'000;
  for (std::size_t i = 0; i < kTexts; ++i) {
    const std::string text = texts.next();
    const CsvOptions options = texts.next_options();
    try {
      const CsvTable table = CsvTable::parse(text, "random.csv", options);
      ++read;
      read_all(table);
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().file, "random.csv") << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
    if (HasFailure()) FAIL() << ::testing::PrintToString(text);
  }
  // Both ends are reached.
  EXPECT_GT(read, kTexts / 10);
  EXPECT_LT(read, kTexts * 9 / 10);
}

}  // namespace
}  // namespace plastica::io
