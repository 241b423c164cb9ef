#include "plastica/io/csv_column.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/lib/io/message_from.hpp"

namespace plastica::io {
namespace {

const CsvTable& csv_of_a_test() {
  static const CsvTable table = CsvTable::parse(
      "Strain [%],Stress [MPa],Load,Ratio [-],Way [mm]\n0,0,0,0,0\n1,200,3,0.01,5\n", "a.csv");
  return table;
}

FoundColumn found(const std::string& name, std::optional<std::string> unit, Dimension dimension,
                  bool override_unit = false) {
  return find_column(csv_of_a_test(), {name, std::move(unit), {"f.toml", 3}, "k", override_unit},
                     dimension);
}

TEST(CsvColumn, TakesTheSameUnitInOtherWords) {
  EXPECT_EQ(found("Stress", "N/mm^2", Dimension::Stress).to_si(2.0), 2e6);
  EXPECT_EQ(found("Stress", "MPa", Dimension::Stress).overridden, "");
  EXPECT_EQ(found("Stress", std::nullopt, Dimension::Stress).to_si(2.0), 2e6);
}

TEST(CsvColumn, RefusesAUnitThatContradictsTheTables) {
  EXPECT_EQ(message_from<InputError>([] { found("Stress", "GPa", Dimension::Stress); }),
            "f.toml:3: k = GPa: contradicts a.csv, where \"Stress\" is in MPa: correct one of "
            "them, or let this one go before (override_unit = true, --override-unit)");
  EXPECT_THROW(found("Strain", "1", Dimension::Strain), InputError);
  // A length that is taken for a strain.
  EXPECT_THROW(found("Way", "%", Dimension::Strain), InputError);
}

TEST(CsvColumn, TakesAUnitThatOverridesAndSaysWhich) {
  const FoundColumn stress = found("Stress", "GPa", Dimension::Stress, true);
  EXPECT_EQ(stress.to_si(2.0), 2e9);
  EXPECT_EQ(stress.overridden, "MPa");
  EXPECT_EQ(found("Load", "kN", Dimension::Force, true).overridden, "");
}

TEST(CsvColumn, RefusesAFactorAndAUnitThatTheNameContradictsUnlessOneGoesBefore) {
  const CsvTable table = CsvTable::parse("Force (10 N),Stress (GPa),b\n,MPa,%\n0,0,0\n1,200,3\n",
                                         "a.csv", {.separator = ','});
  const auto find = [&](const char* name, const char* unit, Dimension dimension, bool overrides) {
    return find_column(table, {name, std::string(unit), {"f.toml", 3}, "k", overrides}, dimension);
  };
  const std::string after =
      ", or give a unit and let it go before (override_unit = true, --override-unit)";
  EXPECT_EQ(message_from<InputError>([&] { find("1", "N", Dimension::Force, false); }),
            "f.toml:3: k = 1: has \"10 N\" in its name in a.csv, and factors are not read: scale "
            "the column" +
                after);
  EXPECT_EQ(find("1", "N", Dimension::Force, true).to_si(2.0), 2.0);
  EXPECT_EQ(message_from<InputError>([&] { find("2", "MPa", Dimension::Stress, false); }),
            "f.toml:3: k = 2: is in GPa by its name and in MPa by the row of units of a.csv: "
            "correct one of them" +
                after);
  EXPECT_EQ(find("2", "MPa", Dimension::Stress, true).to_si(2.0), 2e6);
}

TEST(CsvColumn, TakesNoUnitForNoContradiction) {
  EXPECT_EQ(found("Load", "kN", Dimension::Force).to_si(2.0), 2e3);
  EXPECT_EQ(found("Stress", "1", Dimension::None).to_si(2.0), 2.0) << "a shape";
  EXPECT_DOUBLE_EQ(found("Ratio", "%", Dimension::Strain).to_si(2.0), 0.02);
}

}  // namespace
}  // namespace plastica::io
