#include "plastica/io/hdf5_tables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/hdf5.hpp"
#include "tests/lib/io/message_from.hpp"
#include "tests/lib/io/scratch_folder.hpp"

// Files of other programs, with records and links, are tested by tests/cli/curves_of_hdf5_test.py.
namespace plastica::io {
namespace {

using Names = std::vector<std::string>;

/// A file whose content a function writes.
template <typename Write>
std::string file_with(const ScratchFolder& folder, const Write& write) {
  std::string path = folder.file("curves.h5");
  Hdf5File file = Hdf5File::create(path);
  write(file.root());
  file.commit();
  return path;
}

const std::vector<double> kStrain{0.0, 1.0 / 3.0, 1e-300};
const std::vector<double> kStress{-0.0, std::nextafter(1e9, 2e9), 1e22};

void write_columns(Hdf5Group group) {
  group.write("strain", kStrain);
  group.write("stress", kStress, {.units = "MPa"});
}

TEST(Hdf5Tables, AreFoundInGroupsWithinGroups) {
  const ScratchFolder folder;
  const Hdf5Tables tables(file_with(folder, [](Hdf5Group& root) {
    write_columns(root.group("lot 2/B"));
    write_columns(root.group("lot 2"));
    root.write("alone/strain", kStrain);
    root.write_table<double>("A", std::array{0.0, 1.0, 2.0, 3.0}, 2);
    write_columns(root.group("lot 1/B"));
  }));
  EXPECT_EQ(tables.names(), (Names{"lot 2", "lot 2/B", "A", "lot 1/B"}));
  EXPECT_EQ(tables.matching("*/B"), (Names{"lot 2/B", "lot 1/B"}));
  EXPECT_EQ(tables.matching("/A"), (Names{"A"}));
  EXPECT_EQ(
      message_from<InputError>([&] { tables.matching("b*"); }),
      tables.file() + ": path = b*: matches none of its tables: lot 2, lot 2/B, A and lot 1/B");
}

TEST(Hdf5Tables, HaveTheNumbersBitByBit) {
  const ScratchFolder folder;
  const CsvTable table = CsvTable::read(file_with(folder, [](Hdf5Group& root) {
    write_columns(root.group("A"));
    root.write_texts("A/note", Names{"a\tb", "", "\"c\""});
  }));
  EXPECT_EQ(table.names(), (Names{"strain", "stress", "note"}));
  EXPECT_EQ(table.units(), (Names{"", "MPa", ""}));
  EXPECT_EQ(table.path(), "A");
  EXPECT_EQ(table.numbers(0), kStrain);
  EXPECT_EQ(table.numbers(1), kStress);
  EXPECT_TRUE(std::signbit(table.number(0, 1)));
  EXPECT_EQ(table.cell(0, 2), "a b");
  EXPECT_EQ(table.cell(2, 2), "\"c\"");
  EXPECT_EQ(table.line_of_row(2), 3);
}

TEST(Hdf5Tables, OfTwoDimensionsHaveColumnsByNumberOrName) {
  const ScratchFolder folder;
  const std::array<double, 6> values{1.0, 2.0, 3.0, 4.0, std::numeric_limits<double>::quiet_NaN(),
                                     6.0};
  const Hdf5Tables tables(file_with(folder, [&](Hdf5Group& root) {
    root.write_table<double>("bare", values, 2);
    root.write_table<double>("named", values, 2);
    root.set_attribute("named", "columns", Names{"e [%]", "s"});
    root.set_attribute("named", "units", Names{"%", "kPa"});
    root.write_table<double>("short", values, 2);
    root.set_attribute("short", "columns", Names{"e"});
    root.write_table<double>("units", values, 3);
    root.set_attribute("units", "units", Names{"1", "MPa"});
  }));
  const CsvTable bare = CsvTable::read(tables, "bare");
  EXPECT_EQ(bare.names(), (Names{"", ""}));
  EXPECT_EQ(bare.numbers(1), (std::vector{2.0, 4.0, 6.0}));
  EXPECT_TRUE(std::isnan(bare.number(2, 0)));
  EXPECT_EQ(bare.line_of_row(2), 3);
  const CsvTable named = CsvTable::read(tables, "named");
  EXPECT_EQ(named.names(), (Names{"e", "s"}));
  EXPECT_EQ(named.units(), (Names{"%", "kPa"}));
  const auto said_of = [&](const std::string& path) {
    return message_from<InputError>([&] { CsvTable::read(tables, path); });
  };
  EXPECT_EQ(said_of("short"),
            tables.file() + ": /short: names 1 columns by its attribute columns, of 2");
  EXPECT_EQ(said_of("units"), tables.file() + ": /units/units: has 2 units, of 3 columns");
}

/// A table of numbers is read without a text between; the text says the same.
TEST(Hdf5Tables, OfNumbersAreWhatTheirTextSays) {
  const ScratchFolder folder;
  const double infinite = std::numeric_limits<double>::infinity();
  const Hdf5Tables tables(file_with(folder, [&](Hdf5Group& root) {
    Hdf5Group group = root.group("A");
    group.write("Kraft / kN", kStrain);
    group.write(" \"x\" (mm) ", kStress);
    group.write("rows", std::vector{100000.0, std::numeric_limits<double>::quiet_NaN(), 0.1});
    root.write_table<double>("bare", std::array{1.0, 2.5, infinite, 4.0}, 2);
  }));
  for (const std::string& name : tables.names()) {
    const CsvTable table = CsvTable::read(tables, name);
    const Hdf5Tables::Text text = Hdf5Tables::text_of(tables.columns(name));
    const CsvTable parsed = CsvTable::parse(
        text.text, tables.file(),
        {.separator = '\t', .decimal = '.', .header = text.has_header ? 1 : 0, .is_made = true});
    EXPECT_EQ(table.names(), parsed.names());
    EXPECT_EQ(table.units(), parsed.units());
    ASSERT_EQ(table.rows(), parsed.rows());
    for (std::size_t k = 0; k < table.columns(); ++k) {
      EXPECT_EQ(table.label(k), parsed.label(k));
      for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_EQ(table.cell(row, k), parsed.cell(row, k));
      }
    }
  }
  const CsvTable bare = CsvTable::read(tables, "bare");
  EXPECT_EQ(message_from<InputError>([&] { (void)bare.numbers(0); }),
            tables.file() + ":2: column 1 = inf: is not a number");
  EXPECT_EQ(bare.numbers(1), (std::vector{2.5, 4.0}));
}

TEST(Hdf5Tables, ThatAreNoneAreRefused) {
  const ScratchFolder folder;
  const Hdf5Tables tables(file_with(folder, [](Hdf5Group& root) {
    root.write("unlike/strain", kStrain);
    root.write("unlike/stress", std::vector{1.0, 2.0});
    root.write("units/strain [%]", kStrain, {.units = "mm/mm"});
    root.write("units/stress", kStress);
    root.write("empty/strain", std::vector<double>{});
    root.write("empty/stress", std::vector<double>{});
  }));
  const auto said_of = [&](const std::string& path) {
    return message_from<InputError>([&] { CsvTable::read(tables, path); });
  };
  const std::string file = tables.file() + ": ";
  EXPECT_EQ(said_of("unlike"), file + "/unlike: has columns of unlike lengths: strain 3, stress 2");
  EXPECT_EQ(said_of("units"),
            file + "/units/strain [%]: is in % by its name and in mm/mm by its attribute");
  EXPECT_EQ(said_of("empty"), file + "holds no data row");
  EXPECT_EQ(message_from<InputError>([&] { CsvTable::read(tables.file()); }),
            file + "path: must be one of its tables: unlike, units and empty");
  const std::string none = file_with(folder, [](Hdf5Group& root) { root.write("x", kStrain); });
  EXPECT_TRUE(message_from<InputError>([&] { Hdf5Tables{none}; })
                  .ends_with("holds no table: no group with two columns of numbers, no dataset of "
                             "records, none of two "
                             "dimensions"));
}

TEST(Hdf5Tables, HavePropertiesOfWhichTheNearestCounts) {
  const ScratchFolder folder;
  const Hdf5Tables tables(file_with(folder, [](Hdf5Group& root) {
    write_columns(root.group("lot/A"));
    write_columns(root.group("other"));
    root.set_attribute("lot/A", "S0 [mm^2]", 78.5);
    root.write("lot/A/L0", 50.0, {.units = "mm"});
    root.set_attribute("lot", "L0", 1.0);
    root.set_attribute("lot", "S0", 1.0);
    root.set_attribute("lot", "heat", "H 7");
    root.set_attribute("lot", "several", Names{"a", "b"});
  }));
  const auto table = CsvTable::read_properties(tables, "lot/A");
  ASSERT_TRUE(table.has_value());
  EXPECT_EQ(table->names(), (Names{"S0", "L0", "heat"}));
  EXPECT_EQ(table->units(), (Names{"mm^2", "mm", ""}));
  EXPECT_EQ(table->number(0, 0), 78.5);
  EXPECT_EQ(table->number(0, 1), 50.0);
  EXPECT_EQ(table->cell(0, 2), "H 7");
  EXPECT_FALSE(CsvTable::read_properties(tables, "other").has_value());
}

}  // namespace
}  // namespace plastica::io
