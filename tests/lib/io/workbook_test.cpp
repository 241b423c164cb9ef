#include "plastica/io/workbook.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "plastica/io/csv.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"
#include "tests/support/workbook_file.hpp"

namespace plastica::io {
namespace {

using namespace plastica::testing;

std::vector<std::vector<SheetCell>> curve_rows() {
  return {{text_cell("Specimen"), shared_cell(0)},
          {},
          {text_cell("Strain (%)"), shared_cell(1), text_cell("Remark")},
          {number_cell("0"), number_cell("1.5E-2")},
          {number_cell("0.10000000000000001"), number_cell("200.25"), text_cell("a&amp;b")},
          {number_cell("0.2"), error_cell()},
          {number_cell("0.3"), number_cell("-7")}};
}

const std::vector<std::string> kShared{
    "<t>Zug 1</t>", "<r><t>Stress </t></r><r><t>[MPa]</t></r><rPh><t>aloud</t></rPh>"};

class WorkbookTest : public ::testing::Test {
 protected:
  std::string write(const std::vector<std::pair<std::string, std::string>>& sheets) {
    write_workbook(path_, sheets, kShared);
    return path_;
  }

  const ScratchFolder folder_;
  const std::string path_ = folder_.file("curve.xlsx");
};

TEST_F(WorkbookTest, ReadsTheSheetThatHasATable) {
  write({{"Info", sheet_xml({{text_cell("Machine"), number_cell("7")}})},
         {"Data", sheet_xml(curve_rows())}});
  EXPECT_TRUE(is_workbook(path_));
  const CsvTable table = CsvTable::read(path_);
  EXPECT_EQ(table.sheet(), "Data");
  EXPECT_EQ(table.file(), path_);
  ASSERT_EQ(table.rows(), 4U);
  EXPECT_EQ(table.names()[0], "Strain");
  EXPECT_EQ(table.units()[0], "%");
  EXPECT_EQ(table.names()[1], "Stress") << "of two runs, without how it is read aloud";
  EXPECT_EQ(table.units()[1], "MPa");
  EXPECT_EQ(table.line_of_row(0), 4) << "as the sheet counts, empty rows too";
  EXPECT_EQ(table.number(1, 0), 0.1);
  EXPECT_EQ(table.number(0, 1), 0.015);
  EXPECT_TRUE(std::isnan(table.number(2, 1))) << "#DIV/0!";
  EXPECT_EQ(table.number(3, 1), -7.0);
  EXPECT_EQ(table.cell(1, 2), "a&b");
  ASSERT_FALSE(table.preamble().empty());
  EXPECT_NE(table.preamble()[0].find("Zug 1"), std::string::npos);
}

TEST_F(WorkbookTest, AsksForTheSheetWhereSeveralHaveATable) {
  auto other = curve_rows();
  other.back()[1] = number_cell("99");
  write({{"Probe 1", sheet_xml(curve_rows())}, {"Probe 2", sheet_xml(other)}});
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(path_); }),
            path_ +
                ": sheet: must be named, as several have a table of numbers: Probe 1 (3 rows), "
                "Probe 2 (3 rows)");
  CsvOptions options;
  options.sheet = "Probe 2";
  EXPECT_EQ(CsvTable::read(path_, options).number(3, 1), 99.0);
  options.sheet = "probe 2";
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(path_, options); }),
            path_ + ": sheet = probe 2: is no sheet of this workbook, which has Probe 1, Probe 2");
}

TEST_F(WorkbookTest, FindsTheMarkWhereNumbersAreText) {
  std::vector<std::vector<SheetCell>> rows{{text_cell("Strain"), text_cell("Stress")}};
  for (int i = 0; i < 5; ++i) {
    rows.push_back(
        {text_cell("0," + std::to_string(10 + i)), text_cell("1" + std::to_string(i) + ",25")});
  }
  write({{"A", sheet_xml(rows)}});
  CsvOptions options;
  options.sheet = "A";
  const CsvTable table = CsvTable::read(path_, options);
  EXPECT_EQ(table.number(1, 1), 11.25) << "a comma is a decimal mark here";
  EXPECT_EQ(table.decimal(), ',');
}

/// Two columns of numbers under names; a cell each by `cell`.
template <typename Cell>
std::string table_of(const std::string& second, int rows, const Cell& cell) {
  std::vector<std::vector<SheetCell>> all{{text_cell("Strain"), text_cell(second)}};
  for (int i = 0; i < rows; ++i) all.push_back({number_cell("0.00" + std::to_string(i)), cell(i)});
  return sheet_xml(all);
}

TEST_F(WorkbookTest, ReadsNumbersBesideNumbersThatAreText) {
  // Numbers always have a point in the file; what is text has a mark of its own.
  write({{"A", table_of("Stress [MPa]", 5, [](int i) {
            return text_cell(std::to_string(30 + i) + (i == 0 ? ",5" : ",250"));
          })}});
  const CsvTable commas = CsvTable::read(path_);
  EXPECT_EQ(commas.number(1, 0), 0.001);
  EXPECT_EQ(commas.number(0, 1), 30.5);
  EXPECT_EQ(commas.number(1, 1), 31.25) << "not 31 250";

  write({{"A", table_of("Stress [MPa]", 5,
                        [](int i) { return text_cell("1,23" + std::to_string(i)); })}});
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(path_); }),
            path_ + ": decimal: must be given: numbers such as 1,234 stand in cells that are text");
  CsvOptions options;
  options.decimal = ',';
  EXPECT_EQ(CsvTable::read(path_, options).number(4, 1), 1.234);
  EXPECT_EQ(CsvTable::read(path_, options).number(4, 0), 0.004);
  options.decimal = '.';
  EXPECT_EQ(CsvTable::read(path_, options).number(4, 1), 1234.0);
}

TEST_F(WorkbookTest, TakesPercentagesAsTheyAreShown) {
  const auto percentage = [](int i) {
    return SheetCell{" s=\"1\"><v>0.00" + std::to_string(i) + "</v>"};
  };
  const auto read = [&](const std::string& name, const std::string& format = "0.00%") {
    const std::string styles =
        "<styleSheet><numFmts><numFmt numFmtId='164' formatCode='" + format +
        "'/></numFmts><cellXfs><xf numFmtId='0'/><xf numFmtId='164'/></cellXfs></styleSheet>";
    write_archive(path_, {{"xl/workbook.xml",
                           "<workbook><sheets><sheet name='S' r:id='a'/></sheets></workbook>"},
                          {"xl/_rels/workbook.xml.rels",
                           "<Relationships><Relationship Id='a' Target='./data/one.xml'/>"
                           "<Relationship Id='b' Type='http://x/styles' Target='look.xml'/>"
                           "</Relationships>"},
                          {"xl/look.xml", styles},
                          {"xl/data/one.xml", table_of(name, 6, percentage)}});
    return CsvTable::read(path_).number(5, 1);
  };
  EXPECT_EQ(read("Elongation [%]"), 0.5) << "as it is shown";
  EXPECT_EQ(read("Elongation"), 0.005) << "a fraction";
  for (const char* sign : {"0.0\" %\"", "0.0\\%", "0.0_%", "\"%\"0.0"}) {
    EXPECT_EQ(read("Elongation [%]", sign), 0.005) << sign << ", a sign that scales nothing";
  }
  EXPECT_EQ(read("Elongation [%]", "\"about \"0.0%"), 0.5);
}

TEST_F(WorkbookTest, LooksAtNoHiddenSheetAndReadsALoneOne) {
  write({{"Only", sheet_xml({{text_cell("Name"), text_cell("S0")},
                             {text_cell("a"), number_cell("78.5")}})}});
  EXPECT_EQ(CsvTable::read(path_).number(0, 1), 78.5) << "a table of specimens";
  write_archive(path_, {{"xl/workbook.xml",
                         "<workbook><sheets><sheet name='H' state='hidden' r:id='a'/></sheets>"
                         "</workbook>"},
                        {"xl/_rels/workbook.xml.rels",
                         "<Relationships><Relationship Id='a' Target='worksheets/s.xml'/>"
                         "</Relationships>"},
                        {"xl/worksheets/s.xml", sheet_xml(curve_rows())}});
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(path_); }),
            path_ + ": has no table of numbers on any of its sheets: H (hidden)");
}

TEST_F(WorkbookTest, RefusesFormulasWithoutResults) {
  write({{"A", sheet_xml({{SheetCell{"><f>B1+1</f>"}, number_cell("1")}})}});
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(path_); }),
            path_ + ": has formulas without their results: open it in Excel and save it");
}

TEST_F(WorkbookTest, TakesElementsWithAPrefix) {
  write_archive(
      path_,
      {{"xl/workbook.xml",
        "<x:workbook><x:sheets><x:sheet name='S' r:id='a'/></x:sheets></x:workbook>"},
       {"xl/_rels/workbook.xml.rels",
        "<Relationships><Relationship Id='a' Target='/xl/worksheets/s.xml'/></Relationships>"},
       {"xl/worksheets/s.xml",
        "<x:worksheet><x:sheetData><x:row><x:c><x:v>1</x:v></x:c><x:c><x:v>2</x:v></x:c></x:row>"
        "<x:row><x:c><x:v>3</x:v></x:c><x:c><x:v>4</x:v></x:c></x:row>"
        "<x:row><x:c><x:v>5</x:v></x:c><x:c><x:v>6</x:v></x:c></x:row></x:sheetData></"
        "x:worksheet>"}});
  EXPECT_EQ(read_sheet(path_, {}, {}).text, "1\t2\n3\t4\n5\t6\n");
}

TEST_F(WorkbookTest, RefusesWhatIsNone) {
  const auto said = [&] { return message_of([&] { (void)CsvTable::read(path_); }); };
  write({{"Info", sheet_xml({{text_cell("nothing")}})}});
  EXPECT_EQ(said(), path_ + ": has no table of numbers on any of its sheets: Info");
  write_archive(path_, {{"a.txt", "text"}});
  EXPECT_EQ(said(), path_ + ": is no Excel workbook, or a damaged one: it has no xl/workbook.xml");
  std::ofstream(path_) << "PK\x03\x04 and nothing else";
  EXPECT_EQ(said(), path_ + ": is a damaged archive, no Excel workbook");
  const std::string text = folder_.file("a.csv");
  std::ofstream(text) << "a,b\n1,2\n3,4\n";
  CsvOptions options;
  options.sheet = "A";
  EXPECT_EQ(message_of([&] { (void)CsvTable::read(text, options); }),
            text + ": sheet = A: is of workbooks (.xlsx), which this is not");
  write({{"A", sheet_xml({{shared_cell(5), number_cell("1")}})}});
  EXPECT_EQ(said(), path_ + ": is damaged: a cell has no text");
}

/// Each byte changed, or the end cut off: a table or one line, and never another number in silence.
TEST_F(WorkbookTest, ReadsOrRefusesDamagedOnes) {
  write({{"Data", sheet_xml(curve_rows())}});
  std::ifstream in(path_, std::ios::binary);
  const std::string whole((std::istreambuf_iterator<char>(in)), {});
  const std::vector<double> stresses = CsvTable::read(path_).numbers(1);
  int refused = 0;
  for (std::size_t i = 4; i < whole.size(); i += 7) {
    for (const bool cut : {false, true}) {
      std::string bad = cut ? whole.substr(0, i) : whole;
      if (!cut) bad[i] = static_cast<char>(bad[i] ^ 0x55);
      std::ofstream(path_, std::ios::binary) << bad;
      try {
        const std::vector<double> read = CsvTable::read(path_).numbers(1);
        ASSERT_EQ(read.size(), stresses.size()) << i;
        for (const std::size_t k : {0U, 1U, 3U}) ASSERT_EQ(read[k], stresses[k]) << i;
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, static_cast<int>(whole.size() / 7));
}

}  // namespace
}  // namespace plastica::io
