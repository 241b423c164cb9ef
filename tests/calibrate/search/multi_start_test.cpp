#include "calibrate/search/multi_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace plastica::calibrate {
namespace {

/// Two wells, the better one at 1: r = (x^2 - 1, 0.3 (x - 2)).
double wells(std::span<const double> x, std::span<double> gradient, std::span<double> normal) {
  const double r[] = {x[0] * x[0] - 1.0, 0.3 * (x[0] - 2.0)};
  gradient[0] = 2.0 * x[0] * r[0] + 0.3 * r[1];
  normal[0] = 4.0 * x[0] * x[0] + 0.09;
  return r[0] * r[0] + r[1] * r[1];
}

/// A valley with kinks at every hundredth: r = (1 + 0.1 |sin(100 pi x)|, x).
double teeth(std::span<const double> x, std::span<double> gradient, std::span<double> normal) {
  constexpr double kRate = 314.159265358979;
  const double wave = std::sin(kRate * x[0]);
  const double r[] = {1.0 + 0.1 * std::fabs(wave), x[0]};
  const double slope =
      0.1 * kRate * std::copysign(std::cos(kRate * x[0]), wave * std::cos(kRate * x[0]));
  gradient[0] = slope * r[0] + r[1];
  normal[0] = slope * slope + 1.0;
  return r[0] * r[0] + r[1] * r[1];
}

template <class Squares>
Problem problem_of(Squares squares) {
  Problem problem{{-3.0}, {3.0}, {0.0}, nullptr, squares};
  problem.cost = [squares](std::span<const double> x, std::span<double> gradient) {
    double by_x = 0.0;
    double normal = 0.0;
    const double cost = squares(x, {&by_x, 1}, {&normal, 1});
    if (!gradient.empty()) gradient[0] = 2.0 * by_x;
    return cost;
  };
  return problem;
}

TEST(MultiStart, GoesNoFurtherInABasinThatIsKnown) {
  std::vector<Basin> known;
  int stages = 0;
  const auto count = [&](std::string_view, const Minimum&) { ++stages; };
  const std::vector<std::vector<double>> starts{{0.6}, {0.8}, {1.4}, {-1.3}, {-0.8}};
  const Ends ends =
      search_from(problem_of(wells), starts, {.short_evaluations = 3, .polished = 5, .near = 10.0},
                  {}, count, known);
  ASSERT_EQ(ends.apart.size(), 2U);
  EXPECT_EQ(ends.alike.size(), 3U);
  EXPECT_EQ(known.size(), 2U);
  EXPECT_NEAR(ends.apart[0].x[0], 1.0213, 1e-3);  // 4 x (x^2 - 1) + 0.18 (x - 2) = 0
  EXPECT_NEAR(ends.apart[1].x[0], -0.9262, 1e-3);
  EXPECT_LE(stages, 7) << "a short search each, and two that go on";
}

TEST(MultiStart, LeavesOutStartsWithoutACost) {
  std::vector<Basin> known;
  const auto half = [](std::span<const double> x, std::span<double> gradient,
                       std::span<double> normal) {
    return x[0] < 0.0 ? std::nan("") : wells(x, gradient, normal);
  };
  const Ends ends = search_from(
      problem_of(half), {{-1.0}, {0.9}}, {.polished = 2}, {},
      [](std::string_view, const Minimum&) {}, known);
  EXPECT_EQ(ends.apart.size(), 1U);
  EXPECT_TRUE(ends.alike.empty());
}

/// How many of many points of a valley with kinks go on.
int searches_until(std::size_t enough) {
  std::vector<Minimum> points;
  for (int i = 0; i < 20; ++i) {
    Minimum& point = points.emplace_back();
    point.x = {0.003 + 1e-5 * i};
    point.cost = 1.5 + 0.01 * i;
    point.promised = 1.0;
  }
  int stages = 0;
  Minimum best;
  best.cost = 10.0;
  best = least_of_basin(problem_of(teeth), points, best, {.enough = enough}, {},
                        [&](std::string_view algorithm, const Minimum&) {
                          if (algorithm == "slsqp") ++stages;
                        });
  EXPECT_LE(best.cost, 1.0001 + 1e-6) << "the bottom of one of the first teeth";
  return stages;
}

TEST(MultiStart, EndsOnceEnoughSearchesAgree) {
  EXPECT_EQ(searches_until(3), 3);
  EXPECT_EQ(searches_until(100), 12) << "no more than these";
}

}  // namespace
}  // namespace plastica::calibrate
