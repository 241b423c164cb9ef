#include <gtest/gtest.h>

#include <string>

#include "plastica/io/csv.hpp"
#include "tests/lib/io/message_from.hpp"

namespace plastica::io {
namespace {

std::string parse_error(const std::string& text, const CsvOptions& options = {}) {
  return message_from<InputError>([&] { CsvTable::parse(text, "curve.csv", options); });
}

TEST(CsvErrors, AMissingFileIsNamed) {
  EXPECT_EQ(message_from<InputError>([] { CsvTable::read("no/such/file.csv"); }),
            "no/such/file.csv: cannot be read: No such file or directory");
}

TEST(CsvErrors, AFolderIsNotAFile) {
  EXPECT_EQ(message_from<InputError>([] { CsvTable::read("/"); }),
            "/: cannot be read: Is a directory");
}

TEST(CsvErrors, EmptyTextIsSaidToBeEmpty) {
  EXPECT_EQ(parse_error(""), "curve.csv: is empty");
  EXPECT_EQ(parse_error("\n \n;;\n"), "curve.csv: is empty");
}

TEST(CsvErrors, AHeaderAloneHoldsNoData) {
  EXPECT_EQ(parse_error("a,b\n"), "curve.csv: holds no data row");
  EXPECT_EQ(parse_error("a,b\n", {.header = 1}), "curve.csv: holds no data row");
}

TEST(CsvErrors, BinaryIsRefusedWithWhatToDo) {
  EXPECT_EQ(parse_error(std::string("a,b\n1,\0\n", 8)),
            "curve.csv:2: is not text (it has a zero byte)");
  EXPECT_EQ(parse_error("\xFF\xFE"
                        "a"),
            "curve.csv:1: is UTF-16 text that ends amid a character");
  EXPECT_EQ(parse_error(std::string("PK\x03\x04\0", 5)),
            "curve.csv: is an Excel workbook or another archive: name the file, or save the sheet "
            "as CSV");
  EXPECT_EQ(
      parse_error(std::string("\xD0\xCF\x11\xE0\0", 5)),
      "curve.csv: is an old Excel workbook (.xls), or one with a password: save the sheet as CSV");
  EXPECT_EQ(parse_error(std::string("MATLAB 5.0 MAT-file\0", 20)),
            "curve.csv: is a MATLAB file: write the columns with writematrix(data, \"curve.csv\")");
}

TEST(CsvErrors, ACommaThatMayPartThousandsIsRefused) {
  const std::string rows = "t;F\n1;998\n2;999\n3;1,000\n4;1,001\n";
  EXPECT_EQ(parse_error(rows),
            "curve.csv:4: 1,000: has a decimal mark or one of thousands: say which by decimal = "
            "\".\" or \",\" (--decimal)");
  EXPECT_EQ(CsvTable::parse(rows, "", {.decimal = '.'}).number(3, 1), 1001.0);
  EXPECT_EQ(CsvTable::parse(rows, "", {.decimal = ','}).number(3, 1), 1.001);
  // A number with two decimals, or one below a thousand with three, shows what a comma is.
  EXPECT_EQ(CsvTable::parse(rows + "5;1,25\n", "").number(3, 1), 1.001);
  EXPECT_EQ(CsvTable::parse("t;F\n1;0,998\n2;100\n3;1,000\n", "").number(2, 1), 1.0);
}

TEST(CsvErrors, ARowOfAnotherWidthIsNamedWithItsLine) {
  EXPECT_EQ(parse_error("a,b\n1,2\n3,4\n5\n6,7\n8,9\n"),
            "curve.csv:4: has 1 cell, the header on line 1 has 2");
  EXPECT_EQ(parse_error("a,b\n1,2\n3,4,5\n6,7\n"),
            "curve.csv:3: has 3 cells, the header on line 1 has 2");
  EXPECT_EQ(parse_error("1,2\n3,4\n5,6,7\n8,9\n"),
            "curve.csv:3: has 3 cells, the other rows have 2");
}

TEST(CsvErrors, AHeaderOfAnotherWidthIsNamed) {
  EXPECT_EQ(parse_error("a,b,c\n1,2\n3,4\n5,6\n"),
            "curve.csv:2: has 2 cells, the header on line 1 has 3");
  EXPECT_EQ(parse_error("a,b\n1,2,3\n3,4,3\n5,6,3\n"),
            "curve.csv:2: has 3 cells, the header on line 1 has 2");
}

TEST(CsvErrors, ATextWithoutAnyClosedQuoteIsRefusedWithItsFirstLine) {
  for (const CsvOptions& options : {CsvOptions{}, CsvOptions{.header = 0}}) {
    EXPECT_EQ(parse_error("\n\"", options), "curve.csv:2: has a quote that is not closed");
  }
  EXPECT_EQ(parse_error("\"a\n\"1,2\n\"3\n"), "curve.csv:1: has a quote that is not closed");
}

TEST(CsvErrors, ManyRowsOfNothingAboveABrokenOneAreRead) {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "NA,NA\n";
  text += "5\n1,2\n3,4\n";
  for (int i = 0; i < 20'000; ++i) text += "5,6\n";
  EXPECT_EQ(CsvTable::parse(text, "curve.csv").number(0, 0), 1.0);
}

TEST(CsvErrors, AQuoteThatIsNotClosedIsNamedWithItsLine) {
  EXPECT_EQ(parse_error("a,b\n1,2\n\"3,4\n5,6\n7,8\n"),
            "curve.csv:3: has a quote that is not closed");
  EXPECT_EQ(parse_error("\"a,b\n1,2\n5,6\n", {.header = 1}),
            "curve.csv:1: has a quote that is not closed");
}

TEST(CsvErrors, ACellThatIsNoNumberIsNamedWithLineAndColumn) {
  const CsvTable table = CsvTable::parse("a,\n0,1\n1,2\n3,x7\n5,1e999\n6,inf\n8,9\n", "c.csv");
  EXPECT_EQ(message_from<InputError>([&] { table.number(2, 1); }),
            "c.csv:4: column 2 = x7: is not a number");
  EXPECT_EQ(message_from<InputError>([&] { table.number(3, 1); }),
            "c.csv:5: column 2 = 1e999: is a number out of range");
  EXPECT_EQ(message_from<InputError>([&] { table.number(4, 1); }),
            "c.csv:6: column 2 = inf: is not a number");
  EXPECT_EQ(message_from<InputError>([&] { table.numbers(1); }),
            "c.csv:4: column 2 = x7: is not a number");
}

TEST(CsvErrors, ABrokenFirstRowIsNotTakenForAHeader) {
  EXPECT_EQ(parse_error("a,b\noverflow,2\n1,2\n3,4\n5,6\n7,8\n"),
            "curve.csv:2: overflow: is not a number");
  EXPECT_EQ(parse_error("1,2,x7\n1,2,3\n3,4,5\n5,6,7\n7,8,9\n"),
            "curve.csv:1: x7: is not a number");
}

TEST(CsvErrors, AHeaderLineThatIsNotThereIsNamed) {
  EXPECT_EQ(parse_error("a,b\n1,2\n", {.header = 9}),
            "curve.csv:9: is blank or past the end, so it cannot be the header");
}

TEST(CsvErrors, AnUnknownColumnListsTheColumnsThereAre) {
  const CsvTable named = CsvTable::parse("Strain,Stress\n1,2\n3,4\n", "c.csv");
  EXPECT_EQ(message_from<InputError>([&] {
              named.find("Force", {"fit.toml", 7}, "stress.column");
            }),
            "fit.toml:7: stress.column = Force: is not a column of c.csv, which has 2 columns: "
            "Strain, Stress");
  const CsvTable bare = CsvTable::parse("1,2\n3,4\n", "c.csv");
  EXPECT_EQ(message_from<InputError>([&] { bare.find("3", {}, "column"); }),
            "column = 3: is not a column of c.csv, which has 2 columns without names");
}

TEST(CsvErrors, ANameThatTwoColumnsHaveIsRefused) {
  const CsvTable table = CsvTable::parse("x,y,X\n1,2,3\n4,5,6\n", "c.csv");
  EXPECT_EQ(table.find("x"), 0U);
  const CsvTable twice = CsvTable::parse("x,y,x\n1,2,3\n4,5,6\n", "c.csv");
  EXPECT_EQ(message_from<InputError>([&] { twice.find("x", {}, "column"); }),
            "column = x: is the name of columns 1 and 3 of c.csv; give the number");
  EXPECT_EQ(twice.find("x"), std::nullopt);
}

}  // namespace
}  // namespace plastica::io
