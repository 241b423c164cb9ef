#include "calibrate/search/optimizer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/message.hpp"

namespace plastica::calibrate {
namespace {

using testing::message_of;

/// f = 1 + (x - 0.3)^2 + 2 (y + 0.2)^2 + (x - 0.3)(y + 0.2): convex, minimum 1 at (0.3, -0.2).
double quadratic(std::span<const double> x, std::span<double> gradient) {
  const double u = x[0] - 0.3;
  const double v = x[1] + 0.2;
  if (!gradient.empty()) {
    gradient[0] = 2.0 * u + v;
    gradient[1] = 4.0 * v + u;
  }
  return 1.0 + u * u + 2.0 * v * v + u * v;
}

double rosenbrock(std::span<const double> x, std::span<double> gradient) {
  const double valley = x[1] - x[0] * x[0];
  if (!gradient.empty()) {
    gradient[0] = -400.0 * x[0] * valley - 2.0 * (1.0 - x[0]);
    gradient[1] = 200.0 * valley;
  }
  return 100.0 * valley * valley + (1.0 - x[0]) * (1.0 - x[0]);
}

Problem quadratic_problem() { return {{-1.0, -1.5}, {2.0, 1.0}, {1.5, 0.8}, quadratic}; }

MinimizeOptions options_of(std::string_view algorithm) {
  MinimizeOptions options;
  options.algorithm = algorithm;
  options.max_evaluations = is_global(algorithm) ? 6000 : 3000;
  return options;
}

/// How near an algorithm comes to a minimum of order one: the global ones spread their points.
double nearness(std::string_view algorithm) { return is_global(algorithm) ? 0.03 : 1e-5; }

/// Those of NLopt.
std::vector<std::string_view> all_by_name() {
  std::vector<std::string_view> names;
  for (const std::string_view name : algorithm_names()) {
    if (name != "auto" && name != kGaussNewton) names.push_back(name);
  }
  return names;
}

class EveryAlgorithm : public ::testing::TestWithParam<std::string_view> {};

TEST_P(EveryAlgorithm, MinimizesAQuadraticOverABox) {
  Problem problem = quadratic_problem();
  int gradients = 0;
  bool within = true;
  problem.cost = [&](std::span<const double> x, std::span<double> gradient) {
    gradients += gradient.empty() ? 0 : 1;
    for (std::size_t i = 0; i < 2; ++i) {
      within = within && x[i] >= problem.lower[i] && x[i] <= problem.upper[i];
    }
    return quadratic(x, gradient);
  };
  const Minimum minimum = minimize(problem, options_of(GetParam()));
  EXPECT_TRUE(minimum.usable) << minimum.outcome;
  EXPECT_TRUE(within);
  EXPECT_EQ(gradients > 0, needs_gradient(GetParam()));
  ASSERT_EQ(minimum.x.size(), 2U);
  EXPECT_NEAR(minimum.x[0], 0.3, nearness(GetParam()));
  EXPECT_NEAR(minimum.x[1], -0.2, nearness(GetParam()));
  EXPECT_EQ(minimum.cost, quadratic(minimum.x, {}));
}

TEST_P(EveryAlgorithm, StopsAtAnActiveBound) {
  Problem problem = quadratic_problem();
  problem.upper[0] = 0.1;
  problem.start[0] = -0.5;
  const Minimum minimum = minimize(problem, options_of(GetParam()));
  EXPECT_TRUE(minimum.usable) << minimum.outcome;
  // At x = 0.1 the slope along y vanishes where 4 v + u = 0, u = -0.2.
  EXPECT_NEAR(minimum.x[0], 0.1, nearness(GetParam()));
  EXPECT_NEAR(minimum.x[1], -0.15, nearness(GetParam()));
  EXPECT_LE(minimum.x[0], 0.1);
}

TEST_P(EveryAlgorithm, CarriesAnExceptionOfTheCostOutWhole) {
  struct Special : std::out_of_range {
    Special() : std::out_of_range("special"), code(7) {}
    int code;
  };
  Problem problem = quadratic_problem();
  int calls = 0;
  problem.cost = [&](std::span<const double> x, std::span<double> gradient) {
    if (++calls == 4) throw Special();
    if (calls > 4) throw std::logic_error("called again after an exception");
    return quadratic(x, gradient);
  };
  try {
    minimize(problem, options_of(GetParam()));
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Special& special) {
    EXPECT_EQ(special.code, 7);
    EXPECT_STREQ(special.what(), "special");
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another exception: " << error.what();
  }
}

TEST_P(EveryAlgorithm, CarriesAThrownNumberOut) {
  Problem problem = quadratic_problem();
  problem.cost = [](std::span<const double>, std::span<double>) -> double { throw 42; };
  try {
    minimize(problem, options_of(GetParam()));
    ADD_FAILURE() << "nothing was thrown";
  } catch (int number) {
    EXPECT_EQ(number, 42);
  }
}

TEST_P(EveryAlgorithm, SurvivesCostsThatAreNotNumbers) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Problem problem = quadratic_problem();
    problem.cost = [&](std::span<const double> x, std::span<double> gradient) {
      return x[0] > 0.9 && x[1] > 0.5 ? bad : quadratic(x, gradient);
    };
    problem.start = {-0.5, 0.4};
    const Minimum minimum = minimize(problem, options_of(GetParam()));
    EXPECT_TRUE(minimum.usable) << minimum.outcome;
    EXPECT_NEAR(minimum.cost, 1.0, 0.01);
  }
}

TEST_P(EveryAlgorithm, IsNotUsableWhereNoPointHasACost) {
  Problem problem = quadratic_problem();
  problem.cost = [](std::span<const double>, std::span<double>) {
    return std::numeric_limits<double>::infinity();
  };
  MinimizeOptions options = options_of(GetParam());
  options.max_evaluations = 200;
  const Minimum minimum = minimize(problem, options);
  EXPECT_FALSE(minimum.usable);
  EXPECT_TRUE(minimum.x.empty());
}

TEST_P(EveryAlgorithm, KeepsTheLargestNumberOfEvaluations) {
  for (const int most : {1, 7, 50}) {
    Problem problem{{-2.0, -2.0}, {2.0, 3.0}, {-1.2, 1.0}, rosenbrock};
    MinimizeOptions options = options_of(GetParam());
    options.max_evaluations = most;
    const Minimum minimum = minimize(problem, options);
    EXPECT_LE(minimum.evaluations, most);
    EXPECT_GE(minimum.evaluations, 1);
    EXPECT_TRUE(minimum.usable) << minimum.outcome;
  }
}

/// All bits of a run: points and costs in order.
std::vector<std::uint64_t> bits_of_run(std::string_view algorithm, std::uint64_t seed) {
  std::vector<std::uint64_t> bits;
  Problem problem{{-2.0, -2.0}, {2.0, 3.0}, {-1.2, 1.0}, nullptr};
  problem.cost = [&](std::span<const double> x, std::span<double> gradient) {
    const double cost = rosenbrock(x, gradient);
    for (const double value : {x[0], x[1], cost})
      bits.push_back(std::bit_cast<std::uint64_t>(value));
    return cost;
  };
  MinimizeOptions options = options_of(algorithm);
  options.max_evaluations = 400;
  options.seed = seed;
  const Minimum minimum = minimize(problem, options);
  for (const double value : minimum.x) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

TEST_P(EveryAlgorithm, GivesTheSameBitsAgainAndInEveryThread) {
  const auto expected = bits_of_run(GetParam(), 5);
  EXPECT_EQ(bits_of_run(GetParam(), 5), expected);
  std::vector<std::vector<std::uint64_t>> found(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i) {
    threads.emplace_back([&, i] {
      bits_of_run(GetParam(), 90 + i);  // a run before leaves its random state behind
      found[i] = bits_of_run(GetParam(), 5);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& bits : found) EXPECT_EQ(bits, expected);
}

INSTANTIATE_TEST_SUITE_P(Names, EveryAlgorithm, ::testing::ValuesIn(all_by_name()),
                         [](const auto& named) {
                           std::string name(named.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Optimizer, FollowsRosenbrocksValley) {
  for (const std::string_view name :
       {"slsqp", "lbfgs", "var2", "tnewton", "nelder-mead", "sbplx", "bobyqa"}) {
    const Problem problem{{-2.0, -2.0}, {2.0, 3.0}, {-1.2, 1.0}, rosenbrock};
    const Minimum minimum = minimize(problem, options_of(name));
    EXPECT_TRUE(minimum.usable) << name;
    EXPECT_NEAR(minimum.x[0], 1.0, 1e-4) << name;
    EXPECT_NEAR(minimum.x[1], 1.0, 1e-4) << name;
  }
}

TEST(Optimizer, TwoSeedsSearchDifferently) {
  for (const std::string_view name : {"crs", "isres", "esch"}) {
    EXPECT_NE(bits_of_run(name, 5), bits_of_run(name, 6)) << name;
  }
}

TEST(Optimizer, RefusesAnUnknownNameAndListsAll) {
  const auto expected =
      "algorithm = newton: must be one of auto gauss-newton crs direct-l direct-l-rand isres esch "
      "slsqp lbfgs "
      "var2 tnewton mma ccsaq nelder-mead sbplx bobyqa cobyla";
  MinimizeOptions options;
  options.algorithm = "newton";
  EXPECT_EQ(message_of([&] { minimize(quadratic_problem(), options); }), expected);
  EXPECT_EQ(message_of([] { is_global("newton"); }), expected);
  EXPECT_EQ(message_of([] { needs_gradient("newton"); }), expected);
}

TEST(Optimizer, TakesRoundoffForAnEndThatIsUsable) {
  // Without tolerances an algorithm goes on until double precision allows no progress.
  int limited = 0;
  for (const std::string_view name : all_by_name()) {
    if (is_global(name)) continue;
    MinimizeOptions options = options_of(name);
    options.x_tolerance = 0.0;
    options.cost_tolerance = 0.0;
    const Minimum minimum = minimize(quadratic_problem(), options);
    if (minimum.outcome != "roundoff-limited") continue;
    ++limited;
    EXPECT_TRUE(minimum.usable) << name;
    EXPECT_NEAR(minimum.x[0], 0.3, 1e-6) << name;
    EXPECT_NEAR(minimum.x[1], -0.2, 1e-6) << name;
  }
  EXPECT_GE(limited, 1);
}

}  // namespace
}  // namespace plastica::calibrate
