#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <utility>

#include "tests/cli/curves.hpp"
#include "tests/cli/results.hpp"

namespace plastica::testing {
namespace {

constexpr int kCountOfCurves = 30;

/// Curves, one of them bad. @return their names
std::vector<std::string> write_curves(const Workplace& place) {
  std::vector<std::string> names;
  for (int i = 0; i < kCountOfCurves; ++i) {
    names.push_back(fmt::format("curve-{}.csv", i));
    place.write(names.back(), i == 7 ? "" : broken_curve(300.0 + i, i));
  }
  return names;
}

TEST(SameBits, ComeOutForEveryThreadCount) {
  const Workplace place;
  write_curves(place);
  place.write("fit.toml", fit_file("'curve-*.csv'"));
  std::vector<std::string> results;
  for (const char* threads : {"1", "2", "3", "8"}) {
    results.push_back(std::string(threads) + ".h5");
    const CommandResult ran =
        place.run({"calibrate", "fit.toml", "--quiet", "--threads", threads, "-o", results.back()});
    ASSERT_EQ(ran.code, 1) << ran.err;
  }
  expect_same_bits(place, results);
}

TEST(SameBits, ComeOutForEveryOrderOfTheFiles) {
  const Workplace place;
  std::vector<std::string> names = write_curves(place);
  std::mt19937_64 engine(1);
  std::vector<std::string> results;
  for (int order = 0; order < 3; ++order) {
    results.push_back(std::to_string(order) + ".h5");
    std::vector<std::string> arguments = {"calibrate", "--quiet", "-o", results.back()};
    arguments.insert(arguments.end(), names.begin(), names.end());
    ASSERT_EQ(place.run(arguments).code, 1);
    std::shuffle(names.begin(), names.end(), engine);
  }
  expect_same_bits(place, results);
}

TEST(SameBits, ComeOutForEveryOrderOfTargetsButInTheTextOfTheFitFile) {
  const Workplace place;
  write_curves(place);
  place.write("up.toml", fit_file("['curve-1.csv', 'curve-2.csv', 'curve-7.csv', 'curve-3.csv']"));
  place.write("down.toml",
              fit_file("['curve-3.csv', 'curve-7.csv', 'curve-2.csv', 'curve-1.csv']"));
  ASSERT_EQ(place.run({"calibrate", "up.toml", "--quiet"}).code, 1);
  ASSERT_EQ(place.run({"calibrate", "down.toml", "--quiet"}).code, 1);
  expect_same_bits(place, {"up.h5", "down.h5"}, {"--but", "/inputs"});
  EXPECT_EQ(compare_results(place, {}, {"up.h5", "down.h5"}).code, 1);
}

TEST(SameBits, AreNotFoundWhereAFitWasToldOtherwise) {
  const Workplace place;
  write_curves(place);
  place.write("fit.toml", fit_file("'curve-1.csv'", "algorithm = 'crs'\nseed = 1"));
  place.write("other.toml", fit_file("'curve-1.csv'", "algorithm = 'crs'\nseed = 2"));
  ASSERT_EQ(place.run({"calibrate", "fit.toml", "--quiet"}).code, 0);
  ASSERT_EQ(place.run({"calibrate", "other.toml", "--quiet"}).code, 0);
  const CommandResult compared = compare_results(place, {}, {"fit.h5", "other.h5"});
  EXPECT_EQ(compared.code, 1);
  for (const char* path : {"/options/seed", "/evaluations/values", "/inputs/text"}) {
    EXPECT_NE(compared.out.find(path), std::string::npos) << compared.out << compared.err;
  }
}

/// How many evaluations a result has in its report, and how many rows of them in its file.
std::pair<int, int> evaluations_of(const Workplace& place, const std::string& result) {
  const CommandResult shown = place.run_program(
      PLASTICA_PYTHON,
      {"-c",
       "import h5py, sys; f = h5py.File(sys.argv[1]); rows = f['evaluations/cost'].shape[0]; "
       "print(rows + int(f['fits/evaluations_left_out'][()].sum()), rows)",
       result});
  EXPECT_EQ(shown.code, 0) << shown.err;
  std::pair<int, int> counts;
  std::istringstream(shown.out) >> counts.first >> counts.second;
  return counts;
}

// Of a hundred fits each evaluation is stored, of one more only how many there were.
TEST(LargeRuns, StoreHowManyEvaluationsThereWere) {
  const Workplace place;
  for (int i = 0; i <= 100; ++i) {
    place.write(fmt::format("curve-{:03}.csv", i), broken_curve(300.0 + i, 1));
  }
  place.write("large.toml", fit_file("'curve-*.csv'"));
  place.write("small.toml", fit_file("'curve-0*.csv'"));
  ASSERT_EQ(place.run({"calibrate", "large.toml", "-o", "large.h5", "--quiet"}).code, 0);
  ASSERT_EQ(place.run({"calibrate", "small.toml", "-o", "small.h5", "--quiet"}).code, 0);
  const auto [of_small, rows_of_small] = evaluations_of(place, "small.h5");
  const auto [of_large, rows_of_large] = evaluations_of(place, "large.h5");
  EXPECT_GT(of_small, 100);
  EXPECT_EQ(rows_of_small, of_small);
  EXPECT_GT(of_large, of_small);
  EXPECT_EQ(rows_of_large, 0);
}

}  // namespace
}  // namespace plastica::testing
