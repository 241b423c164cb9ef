#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "plastica/io/csv.hpp"
#include "tests/support/shared.hpp"

namespace plastica::io {
namespace {

using Names = std::vector<std::string>;

TEST(CsvReference, ReadsEverySharedLaboratoryFile) {
  PLASTICA_NEEDS_SHARED("data");
  const std::filesystem::path shared = plastica::testing::shared_path("data");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shared)) {
    if (entry.path().extension() != ".csv") continue;
    const CsvTable table = CsvTable::read(entry.path().string());
    EXPECT_GE(table.rows(), 3U) << entry.path();
    EXPECT_GE(table.columns(), 2U) << entry.path();
    const bool headerless = entry.path().filename() == "headerless.csv";
    EXPECT_EQ(table.names()[0].empty(), headerless) << entry.path();
    EXPECT_FALSE(table.torn_last_row()) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 60);
  const CsvTable raw = CsvTable::read((shared / "s355-bam" / "Zx2.csv").string());
  EXPECT_EQ(raw.rows(), 12781U);
  EXPECT_EQ(raw.units(), (Names{"sec", "mm", "kN", "%"}));
  EXPECT_EQ(raw.number(12780, 2), 25.13275);
  EXPECT_TRUE(std::isnan(raw.number(12780, 3)));
}

}  // namespace
}  // namespace plastica::io
