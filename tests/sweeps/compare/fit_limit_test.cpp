#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "sweeps/compare/extrapolation.hpp"

namespace plastica::sweeps {
namespace {

/// f = 3 + a h^p + b t^q on a grid of sizes that are halved.
struct Law {
  double a = 0.0;
  double p = 0.0;
  double b = 0.0;
  double q = 0.0;
  std::size_t sizes = 3;
  double noise = 0.0;

  std::vector<double> size{};
  std::vector<double> value{};

  void fill() {
    std::mt19937 generator(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    for (std::size_t i = 0; i < sizes; ++i) {
      for (std::size_t j = 0; j < sizes; ++j) {
        const double h = 0.25 * std::pow(0.5, static_cast<double>(i));
        const double t = 0.004 * std::pow(0.5, static_cast<double>(j));
        size.push_back(h);
        size.push_back(t);
        value.push_back(3.0 + a * std::pow(h, p) + b * std::pow(t, q) + noise * normal(generator));
      }
    }
  }
};

std::optional<Limit> limit_of(Law law) {
  law.fill();
  return fit_limit(law.size, 2, law.value);
}

TEST(FitLimit, FindsTheLimitAndTheOrderOfEachAxis) {
  for (const std::size_t sizes : {3U, 4U}) {
    const auto limit = limit_of({8.0, 2.0, -40.0, 1.0, sizes});
    ASSERT_TRUE(limit.has_value());
    // Orders are searched to 1e-11; what is left of the residual is rounding of values of 3.
    EXPECT_NEAR(limit->value, 3.0, 1e-8);
    EXPECT_NEAR(limit->order[0], 2.0, 1e-5);
    EXPECT_NEAR(limit->order[1], 1.0, 1e-5);
    const double finest = std::pow(0.5, static_cast<double>(sizes - 1));
    EXPECT_NEAR(limit->constant[0], 8.0 * std::pow(0.25 * finest, 2.0), 1e-6);
    EXPECT_NEAR(limit->constant[1], -40.0 * 0.004 * finest, 1e-6);
    EXPECT_LT(limit->uncertainty, 1e-6);
  }
}

TEST(FitLimit, IsTheSameWhicheverAxisIsTheFirst) {
  Law law{8.0, 2.0, -40.0, 1.5};
  law.fill();
  std::vector<double> swapped;
  for (std::size_t i = 0; i < law.value.size(); ++i) {
    swapped.push_back(law.size[2 * i + 1]);
    swapped.push_back(law.size[2 * i]);
  }
  const auto one = fit_limit(law.size, 2, law.value);
  const auto other = fit_limit(swapped, 2, law.value);
  ASSERT_TRUE(one && other);
  EXPECT_NEAR(one->value, other->value, 1e-8);
  EXPECT_NEAR(one->order[0], other->order[1], 1e-4);
}

TEST(FitLimit, StatesAnUncertaintyThatHoldsTheLimitOfNoisyValues) {
  const auto limit = limit_of({8.0, 2.0, -40.0, 1.0, 4, 1e-4});
  ASSERT_TRUE(limit.has_value());
  EXPECT_GT(limit->uncertainty, 1e-5);
  EXPECT_LT(std::abs(limit->value - 3.0), limit->uncertainty);
  // A hundredth of the noise, a hundredth of the uncertainty, but for curvature.
  const auto quiet = limit_of({8.0, 2.0, -40.0, 1.0, 4, 1e-6});
  ASSERT_TRUE(quiet.has_value());
  EXPECT_NEAR(quiet->uncertainty / limit->uncertainty, 0.01, 0.003);
}

TEST(FitLimit, LeavesOutAnAxisThatMovesNothing) {
  const auto limit = limit_of({8.0, 2.0, 0.0, 1.0});
  ASSERT_TRUE(limit.has_value());
  EXPECT_NEAR(limit->value, 3.0, 1e-8);
  EXPECT_EQ(limit->order[1], 0.0);
  const auto still = limit_of({0.0, 2.0, 0.0, 1.0});
  ASSERT_TRUE(still.has_value());
  EXPECT_EQ(still->value, 3.0);
}

TEST(FitLimit, HasNoneOfValuesThatDoNotConverge) {
  EXPECT_FALSE(limit_of({8.0, -1.0, -40.0, 1.0}).has_value());  // grows as h falls
  EXPECT_FALSE(limit_of({8.0, 2.0, -40.0, 1.0, 2}).has_value()) << "four values, five numbers";
}

TEST(FitLimit, IsNoSurerThanItMayBeWhereErrorsOfTwoOrdersCancelAlongAnAxis) {
  // 3 + h^2 - c h + t/2, h = 1/8 ... 1/64.
  int found = 0;
  for (double c = 0.0; c < 0.6; c += 0.01) {
    std::vector<double> sizes;
    std::vector<double> values;
    for (const double n : {8.0, 16.0, 32.0, 64.0}) {
      for (const double t : {0.04, 0.02, 0.01}) {
        sizes.insert(sizes.end(), {1.0 / n, t});
        values.push_back(3.0 + 1.0 / (n * n) - c / n + 0.5 * t);
      }
    }
    const auto limit = fit_limit(sizes, 2, values);
    if (!limit) continue;
    ++found;
    EXPECT_GE(limit->uncertainty, std::abs(limit->value - 3.0) - 1e-8) << c;
  }
  EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace plastica::sweeps
