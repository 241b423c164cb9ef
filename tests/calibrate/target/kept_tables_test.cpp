#include "calibrate/target/kept_tables.hpp"

#include <gtest/gtest.h>

namespace plastica::calibrate {
namespace {

io::CsvTable table(const std::string& name) {
  return io::CsvTable::parse("Strain,Stress\n0,0\n0.001,200\n", name);
}

TEST(KeptTables, HandOutATableOnce) {
  KeptTables kept;
  kept.keep({}, table("a.csv"));
  const auto taken = kept.take("a.csv", {});
  ASSERT_TRUE(taken.has_value());
  EXPECT_EQ(taken->number(1, 1), 200.0);
  EXPECT_FALSE(kept.take("a.csv", {}).has_value());
  EXPECT_FALSE(kept.take("b.csv", {}).has_value());
}

TEST(KeptTables, HandOutNothingThatWasReadInAnotherWay) {
  KeptTables kept;
  kept.keep({}, table("a.csv"));
  EXPECT_FALSE(kept.take("a.csv", {.decimal = ','}).has_value());
  EXPECT_TRUE(kept.take("a.csv", {}).has_value());
}

TEST(KeptTables, TakeNoMoreMemoryThanTheyMay) {
  const std::size_t one = table("a.csv").bytes();
  KeptTables kept(one + one / 2);
  kept.keep({}, table("a.csv"));
  kept.keep({}, table("b.csv"));
  EXPECT_FALSE(kept.take("b.csv", {}).has_value());
  EXPECT_TRUE(kept.take("a.csv", {}).has_value());
  kept.keep({}, table("b.csv"));
  EXPECT_TRUE(kept.take("b.csv", {}).has_value());
}

}  // namespace
}  // namespace plastica::calibrate
