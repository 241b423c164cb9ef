#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/workbook.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/support/workbook_file.hpp"

/// Inputs that once took a minute, and that no file of reproducers/ should be as large as. Nothing
/// here looks at a clock: the time limit of the test sees it.
namespace plastica::fuzz {
namespace {

TEST(ReaderSizes, ALineOfManyCellsIsLookedThroughOnce) {
  constexpr std::size_t kColumns = 400'000;
  std::string row = "1";
  for (std::size_t i = 1; i < kColumns; ++i) row += ",1";
  const auto table = io::CsvTable::parse(row + "\n" + row + "\n", "wide.csv");
  EXPECT_EQ(table.columns(), kColumns);
}

TEST(ReaderSizes, AWorkbookOfFewCellsFarApartIsRefused) {
  std::string rows;
  for (int i = 0; i < 4000; ++i) {
    rows += "<row><c r=\"A1\"><v>1</v></c><c r=\"XFD1\"><v>2</v></c></row>";
  }
  const std::string path = scratch_path("sparse.xlsx");
  testing::write_workbook(path,
                          {{"a", "<worksheet><sheetData>" + rows + "</sheetData></worksheet>"}});
  EXPECT_THROW(io::read_sheet(path, {}, {}), InputError);
}

}  // namespace
}  // namespace plastica::fuzz
