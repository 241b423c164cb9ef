#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "plastica/io/toml.hpp"
#include "plastica/io/toml_edit.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::io {
namespace {

/// Pieces with their numbers from 0 on.
std::string numbered(std::size_t count, const std::function<std::string(std::size_t)>& piece) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += piece(i);
  return text;
}

/// Reads texts of a few parts and of many. What grows with the square of their number takes minutes
/// for the many, and the test's time limit ends it.
void expect_read(const std::function<std::string(std::size_t)>& text_of,
                 const std::function<void(const std::string&)>& read) {
  for (const std::size_t count :
       {std::size_t{2500}, std::size_t{testing::kSanitized ? 10'000 : 40'000}})
    EXPECT_NO_THROW(read(text_of(count))) << count;
}

void parse(const std::string& text) { TomlDocument::parse(text, "f.toml"); }

TEST(TomlSize, ALongLineOfValuesIsRead) {
  const auto values = [](std::size_t n) {
    return numbered(n, [](std::size_t) { return "0.125, "; }) + "]\n";
  };
  expect_read([&](std::size_t n) { return "a = [" + values(n); }, parse);
  expect_read([&](std::size_t n) { return "a = [\"\u00b5\", " + values(n); }, parse);
  expect_read(
      [](std::size_t n) {
        return "a = [" + numbered(n, [](std::size_t) { return "[1, 2], "; }) + "]\n";
      },
      parse);
}

TEST(TomlSize, KeysAreFoundInATableOfMany) {
  expect_read(
      [](std::size_t n) {
        return numbered(n, [](std::size_t i) { return "k" + std::to_string(i) + " = 1\n"; });
      },
      [](const std::string& text) {
        const TomlTable root = TomlDocument::parse(text, "f.toml").root();
        for (const std::string& key : root.keys()) EXPECT_EQ(root.at(key).number(), 1.0);
        root.check_unused();
      });
}

TEST(TomlSize, ALongNameIsNotRepeatedForEachKeyBelowIt) {
  const std::string name(10'000, 'x');
  expect_read(
      [&](std::size_t n) {
        return "[" + name + "]\n" +
               numbered(n, [](std::size_t i) { return "k" + std::to_string(i) + " = 1\n"; });
      },
      parse);
}

TEST(TomlSize, ManyTablesAreReadAndEdited) {
  const auto tables = [](std::size_t n) {
    return numbered(n, [](std::size_t i) { return "[[t]]\nx = " + std::to_string(i) + "\n"; });
  };
  expect_read(tables, [](const std::string& text) {
    const TomlTable root = TomlDocument::parse(text, "f.toml").root();
    for (const TomlTable& table : root.find_tables("t")) (void)table.at("x").number();
    root.check_unused();
  });
  expect_read(tables, [](const std::string& text) { set_toml_value(text, "t[2000].y", "1"); });
}

TEST(TomlSize, ColumnsOfALongLineAreThoseOfItsCharacters) {
  // Characters of one to four bytes, at and around every multiple of 64.
  std::string list;
  for (int i = 0; i < 300; ++i) {
    list += (i == 0 ? "" : ", ") + std::string("'") +
            std::string(static_cast<std::size_t>(i % 7), 'x') +
            (i % 3 == 0   ? "\u00e9"
             : i % 3 == 1 ? "\u20ac"
                          : "\U0001F600") +
            "'";
  }
  const TomlDocument document =
      TomlDocument::parse("# \u00b5\nb = 'y'\na = [" + list + "] # \u00b5\nc = 2\n", "f.toml");
  const TomlTable& root = document.root();
  EXPECT_EQ(root.at("a").written(), "[" + list + "]");
  for (const TomlValue& item : root.at("a").array()) {
    EXPECT_EQ(item.written(), "'" + item.string() + "'");
  }
  EXPECT_EQ(root.at("c").written(), "2");
}

}  // namespace
}  // namespace plastica::io
