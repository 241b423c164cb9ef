#include "plastica/io/result_difference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "plastica/io/hdf5.hpp"
#include "plastica/io/result_file.hpp"
#include "tests/lib/io/scratch_folder.hpp"
#include "tests/support/message.hpp"

namespace plastica::io {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Two files, each with one dataset of numbers.
class ResultDifferences : public ::testing::Test {
 protected:
  template <typename T>
  ResultComparison compare(const std::vector<T>& a, const std::vector<T>& b,
                           const DifferenceRule& rule = {}) {
    write("a.h5", a);
    write("b.h5", b);
    return compare_results(folder_.file("a.h5"), folder_.file("b.h5"), rule);
  }
  template <typename T>
  void write(const std::string& name, const std::vector<T>& values, int version = 1) {
    Hdf5File file = Hdf5File::create(folder_.file(name));
    write_schema(file.root(), "plastica/test", version);
    file.root().write("table/value", values, {"Pa"});
    file.root().write_texts("table/name", std::vector<std::string>(values.size(), "row"));
    write_meta(file.root(), begin_meta("test", 1));
    file.commit();
  }

  ScratchFolder folder_;
};

TEST_F(ResultDifferences, AreNoneOfTheSame) {
  const ResultComparison found =
      compare<double>({1.0, kNaN, kInfinity, -0.0}, {1.0, kNaN, kInfinity, 0.0});
  EXPECT_EQ(found.differing, 0U);
  EXPECT_EQ(found.numbers, 5U);  // four, and the version
  EXPECT_EQ(found.texts, 6U);    // four names, the schema and the unit
}

TEST_F(ResultDifferences, AreOneBitWhereNothingIsAllowed) {
  const double next = std::nextafter(1.0, 2.0);
  const ResultComparison found = compare<double>({0.0, 1.0}, {0.0, next});
  ASSERT_EQ(found.differences.size(), 1U);
  EXPECT_EQ(found.differences[0].place, "/table/value");
  EXPECT_EQ(found.differences[0].row, "row");
  EXPECT_EQ(found.differences[0].first, "1");
  EXPECT_EQ(found.differences[0].second, "1.0000000000000002");
  EXPECT_EQ(found.differences[0].relative, (next - 1.0) / next);
  EXPECT_EQ(compare<double>({1.0}, {next}, {.within = 1e-15}).differing, 0U);
}

TEST_F(ResultDifferences, AreTakenOverTheLargerNumber) {
  EXPECT_EQ(compare<double>({100.0}, {110.0}, {.within = 0.0909}).differing, 1U);
  EXPECT_EQ(compare<double>({100.0}, {110.0}, {.within = 0.091}).differing, 0U);
  EXPECT_EQ(compare<double>({110.0}, {100.0}, {.within = 0.091}).differing, 0U);
  EXPECT_EQ(compare<double>({1.0}, {-1.0}, {.within = 0.99}).largest, 2.0);
  // Their difference is beyond the largest number.
  EXPECT_EQ(compare<double>({1e308}, {-1e308}).largest, 2.0);
}

TEST_F(ResultDifferences, OfAZeroAreWholeUnlessBelowTheFloor) {
  const auto of_zero = compare<double>({1.0, 0.0}, {1.0, 1e-20}, {.within = 0.9});
  ASSERT_EQ(of_zero.differing, 1U);
  EXPECT_EQ(of_zero.differences[0].relative, 1.0);
  EXPECT_EQ(compare<double>({1.0, 0.0}, {1.0, 1e-20}, {.within = 0.9, .floor = 1e-12}).differing,
            0U);
  EXPECT_EQ(compare<double>({1.0, 0.0}, {1.0, 1e-11}, {.within = 0.9, .floor = 1e-12}).differing,
            1U);
  // The largest counts in either file, and what is infinite does not.
  EXPECT_EQ(compare<double>({kInfinity, 0.0}, {kInfinity, 1e-20}, {.floor = 1e-12}).differing, 1U);
}

TEST_F(ResultDifferences, OfWhatIsNotFiniteAreNeverWithin) {
  for (const double other : {1.0, kInfinity, -kInfinity}) {
    const auto found = compare<double>({kNaN}, {other}, {.within = 0.99, .floor = 0.99});
    EXPECT_EQ(found.differing, 1U) << other;
    EXPECT_FALSE(found.differences[0].relative);
  }
  EXPECT_EQ(compare<double>({kInfinity}, {-kInfinity}, {.within = 0.99}).differing, 1U);
  EXPECT_EQ(compare<double>({kInfinity}, {1e300}, {.within = 0.99}).differing, 1U);
}

TEST_F(ResultDifferences, OfLargeIntegersAreSeen) {
  const std::uint64_t large = (std::uint64_t{1} << 63U) + 1;
  const auto found = compare<std::uint64_t>({large}, {large + 1});
  ASSERT_EQ(found.differing, 1U);
  EXPECT_EQ(found.differences[0].first, "9223372036854775809");
  EXPECT_EQ(compare<std::int64_t>({-5}, {-6}).differences.at(0).second, "-6");
  EXPECT_EQ(compare<std::int64_t>({-5}, {-6}, {.within = 0.2}).differing, 0U);
}

TEST_F(ResultDifferences, OfExtentsVersionsAndUnitsAreSeen) {
  const auto longer = compare<double>({1.0}, {1.0, 2.0});
  ASSERT_EQ(longer.differing, 2U);  // values and names
  EXPECT_EQ(longer.differences[0].first, "extents 1");
  EXPECT_EQ(longer.differences[0].second, "extents 2");
  write<double>("a.h5", {1.0}, 1);
  write<double>("b.h5", {1.0}, 2);
  const auto version = compare_results(folder_.file("a.h5"), folder_.file("b.h5"), {});
  ASSERT_EQ(version.differing, 1U);
  EXPECT_EQ(version.differences[0].place, "/ @version");
  EXPECT_EQ(compare_results(folder_.file("a.h5"), folder_.file("b.h5"), {.left_out = {"@version"}})
                .differing,
            0U);
  write<std::int64_t>("b.h5", {1});
  EXPECT_EQ(
      compare_results(folder_.file("a.h5"), folder_.file("b.h5"), {}).differences.at(0).second,
      "integers");
}

TEST_F(ResultDifferences, OfTheSurfaceForParaviewAreLeftOut) {
  write<double>("a.h5", {1.0});
  Hdf5File other = Hdf5File::create(folder_.file("b.h5"));
  write_schema(other.root(), "plastica/test", 1);
  other.root().write("table/value", std::vector<double>{1.0}, {"Pa"});
  other.root().write_texts("table/name", std::vector<std::string>{"row"});
  other.root().write("VTKHDF/Points", std::vector<float>{1.0F});
  write_meta(other.root(), begin_meta("test", 1));
  other.commit();
  for (const auto& [a, b] : {std::pair("a.h5", "b.h5"), std::pair("b.h5", "a.h5")}) {
    EXPECT_EQ(compare_results(folder_.file(a), folder_.file(b), {}).differing, 0U);
  }
}

TEST_F(ResultDifferences, AreListedUpToANumber) {
  const auto found = compare<double>({1.0, 2.0, 3.0}, {2.0, 3.0, 4.0}, {.kept = 1});
  EXPECT_EQ(found.differing, 3U);
  EXPECT_EQ(found.differences.size(), 1U);
}

TEST_F(ResultDifferences, AreRefusedOfOtherKindsAndOfWhatIsNotThere) {
  write<double>("a.h5", {1.0});
  Hdf5File other = Hdf5File::create(folder_.file("b.h5"));
  write_schema(other.root(), "plastica/other", 1);
  other.commit();
  const std::string a = folder_.file("a.h5");
  EXPECT_EQ(plastica::testing::message_of([&] { compare_results(a, folder_.file("b.h5"), {}); }),
            folder_.file("b.h5") + ": schema = plastica/other: must be plastica/test, as of " + a);
  EXPECT_EQ(plastica::testing::message_of([&] { compare_results(a, a, {.left_out = {"/tabel"}}); }),
            "--ignore = /tabel: is in neither file");
}

}  // namespace
}  // namespace plastica::io
