#include "plastica/io/toml_scan.hpp"

#include <gtest/gtest.h>

#include <string>

#include "plastica/io/toml.hpp"
#include "plastica/io/toml_edit.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

using testing::message_of;

std::string repeated(const std::string& piece, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

/// "a.a.a" for three.
std::string names(std::size_t count) { return "a" + repeated(".a", count - 1); }

void expect_refused(const std::string& text, int line) {
  try {
    TomlDocument::parse(text, "f.toml");
    FAIL() << text.substr(0, 100);
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().line, line) << error.what();
    EXPECT_EQ(error.rule(), "is nested in more than 64 tables and lists");
  }
}

void expect_read(const std::string& text) {
  EXPECT_NO_THROW(TomlDocument::parse(text, "f.toml")) << text.substr(0, 100);
}

TEST(TomlScan, AKeyOfManyNamesIsRefusedWithItsLine) {
  expect_read(names(64) + " = 1\n");
  expect_refused("# .\nb = 1\n" + names(65) + " = 1\n", 3);
  expect_refused(names(100'000) + " = 1\n", 1);
  EXPECT_EQ(message_of([] { TomlDocument::parse("\n  " + names(65) + " = 1\n", "f.toml"); }),
            "f.toml:2: " + names(40) + "....: is nested in more than 64 tables and lists");
}

TEST(TomlScan, AHeaderOfManyNamesIsRefused) {
  expect_read("[" + names(63) + "]\nb = 1\n");
  expect_refused("\n[" + names(65) + "]\n", 2);
  expect_refused("[[" + names(100'000) + "]]\n", 1);
  expect_refused("[[" + names(64) + "]]\n", 1);
}

TEST(TomlScan, BracketsAreCounted) {
  expect_read("a = " + repeated("[", 63) + repeated("]", 63) + "\n");
  expect_refused("a = " + repeated("[", 64) + repeated("]", 64) + "\n", 1);
  expect_refused("a = " + repeated("[\n", 100'000), 64);
  expect_refused("a = " + repeated("{a = ", 64) + "1" + repeated("}", 64) + "\n", 1);
}

TEST(TomlScan, HeaderKeyAndBracketsAddUp) {
  const std::string inside = "{" + names(20) + " = [{" + names(20) + " = 1}]}";
  expect_read("[" + names(10) + "]\n" + names(10) + " = " + inside + "\n");
  expect_refused("[" + names(12) + "]\n" + names(10) + " = " + inside + "\n", 2);
  // What is closed no longer counts, nor does the header before.
  expect_read(repeated("[" + names(30) + "]\n" + names(30) + " = [[1], [2]]\n[b]\n", 1));
  std::string many = "b = [";
  for (int i = 0; i < 100; ++i) many += "[{" + names(30) + " = 1.5}, [3.25, 1.0e3]],\n";
  expect_read(many + "]\n");
}

TEST(TomlScan, StringsAndCommentsAreText) {
  const std::string dots = repeated(".[{", 100);
  expect_read("# " + dots + "\na = \"" + dots + "\\\"" + dots + "\" # " + dots + "\n");
  expect_read("a = '" + dots + "\\'\nb = 1\n");
  expect_read("a = \"\"\"\n" + dots + "\"" + dots + "\"\"\n\\\"\"\"" + dots +
              "\"\"\"\"\"\nb = 1\n");
  expect_read("a = '''\n" + dots + "\n''" + dots + "'''''\nb = ''\n");
  expect_read("\"" + dots + "\".\"" + dots + "\" = 1\n[\"x" + dots + "\"]\n");
  // A scan that took a quote for a string's end would not see these.
  expect_refused("a = \"\\\\\"\n" + names(65) + " = 1\n", 2);
  expect_refused("a = \"\"\"x\"\"\"\"\"\n" + names(65) + " = 1\n", 2);
  expect_refused("a = '''x\n\n'''''\n" + names(65) + " = 1\n", 4);
  expect_refused("a = \"\"\nb = ''\n" + names(65) + " = 1\n", 3);
}

TEST(TomlScan, CharactersOutsideOfQuotesAreAscii) {
  const auto error = [](const std::string& text) {
    return message_of([&] { TomlDocument::parse(text, "f.toml"); });
  };
  const std::string rule =
      "'\u00b5' outside of quotes; words and quantities stand in quotes, \"355 MPa\"";
  EXPECT_EQ(error("\u00b5m = 1\n"), "f.toml:1: \u00b5m = 1: is not TOML (column 1): " + rule);
  EXPECT_EQ(error("[\u00b5]\n"), "f.toml:1: [\u00b5]: is not TOML (column 2): " + rule);
  EXPECT_EQ(error("\na = {\u00b5 = 1}\n"),
            "f.toml:2: a = {\u00b5 = 1}: is not TOML (column 6): " + rule);
  EXPECT_EQ(error("# \u00b5\n a = '\u00b5' \u00b5m\n"),
            "f.toml:2: a = '\u00b5' \u00b5m: is not TOML (column 10): " + rule);
  EXPECT_EQ(error("a = 1 \xFF\n").find('\xFF'), std::string::npos);
}

TEST(TomlScan, ABracketIsClosedByItsOwnKind) {
  EXPECT_EQ(message_of([] { TomlDocument::parse("a = [\n1}\n", "f.toml"); }),
            "f.toml:2: 1}: is not TOML (column 2): '}' cannot close '['");
  EXPECT_EQ(message_of([] { TomlDocument::parse("a = {b = 1]\n", "f.toml"); }),
            "f.toml:1: a = {b = 1]: is not TOML (column 11): ']' cannot close '{'");
}

TEST(TomlScan, NoStringBeginsAmidAWord) {
  EXPECT_EQ(message_of([] { TomlDocument::parse("a = 1'\u00b5'\n", "f.toml"); }),
            "f.toml:1: a = 1'\u00b5': is not TOML (column 6): a quote amid a word");
  expect_read("'a'.\"b\"=['x','''y''',\"z\",{\"c\"=\"\"}]\n\"d\"='1'\n[\"e\"]\n");
}

TEST(TomlScan, AHeaderNeedsAName) {
  for (const char* header : {"[", "[]", "[ .a]", "[#]", "[[", "[[]]", "[[\t]]", "[[.]]", "[ \n]"}) {
    EXPECT_NE(message_of([&] {
                TomlDocument::parse(header, "f.toml");
              }).find("): a header needs a name in its brackets"),
              std::string::npos)
        << header;
  }
  expect_read("[ \t'a']\n[[ b]]\n[[-]]\n");
}

TEST(TomlScan, WhatIsNotTomlIsLeftToTheParser) {
  for (const char* text : {"a = \"x\nb = 1\n", "]\n", "}}]\n", "a = [\n", "[a\n[b\n", "= = =\n",
                           "a = '''", "\"\"\"", "\\", "a = \"\\"}) {
    EXPECT_NO_THROW(scan_toml(text, "f.toml")) << text;
    EXPECT_NE(message_of([&] { TomlDocument::parse(text, "f.toml"); }), "no error") << text;
  }
}

TEST(TomlScan, AnEditedTextAndItsValueAreCheckedToo) {
  EXPECT_NE(message_of([] { set_toml_value(names(70) + " = 1\n", "b", "1"); }).find("64 tables"),
            std::string::npos);
  const std::string deep = repeated("[", 100'000) + repeated("]", 100'000);
  EXPECT_NE(message_of([&] { set_toml_value("b = 1\n", "b", deep); }).find("is not a TOML value"),
            std::string::npos);
}

}  // namespace
}  // namespace plastica::io
