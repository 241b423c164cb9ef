#include "calibrate/inference/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

// Likelihood intervals against closed forms; the cost is over the noise, so that it rises by 4 at
// two standard errors.

namespace plastica::calibrate {
namespace {

constexpr ProfileOptions kTwoErrors{.rise = 4.0};

LeastSquaresProblem problem_of(std::size_t n, std::size_t residuals,
                               LeastSquaresProblem::AtPoint at) {
  LeastSquaresProblem problem;
  problem.lower.assign(n, -10.0);
  problem.upper.assign(n, 10.0);
  problem.start.assign(n, 0.1);
  problem.residuals = residuals;
  problem.evaluate = one_by_one(std::move(at));
  return problem;
}

ProfileStart best_of(const LeastSquaresProblem& problem) {
  const LeastSquares found = minimize_squares(problem, {});
  ProfileStart best;
  best.x = found.x;
  best.cost = found.cost;
  return best;
}

ProfileSide side(const LeastSquaresProblem& problem, std::size_t k, bool up,
                 ProfileOptions options = kTwoErrors) {
  ProfileStart best = best_of(problem);
  best.value = best.x[k];
  return profile_coordinate(problem, best, k, up, options);
}

/// A line through points that are on none: a = 2.2, b = 0.8 and (J^T J)^-1 = [0.6 -0.2; -0.2 0.1].
LeastSquaresProblem line() {
  return problem_of(2, 5, [](std::span<const double> x, std::span<double> r) {
    const double y[] = {2.0, 3.0, 4.5, 4.0, 5.5};
    for (std::size_t i = 0; i < 5; ++i) r[i] = x[0] + x[1] * static_cast<double>(i) - y[i];
    return true;
  });
}

TEST(Profile, IsTheCovariancesIntervalOfALinearModel) {
  for (const bool up : {false, true}) {
    const double sign = up ? 1.0 : -1.0;
    const ProfileSide a = side(line(), 0, up), b = side(line(), 1, up);
    EXPECT_EQ(a.why, ProfileEnd::Crossed);
    EXPECT_NEAR(a.end, 2.2 + sign * 2.0 * std::sqrt(0.6), 1e-6);
    EXPECT_NEAR(b.end, 0.8 + sign * 2.0 * std::sqrt(0.1), 1e-6);
    // The other coordinate on the straight line of the least cost, b - 0.8 = -(a - 2.2)/3, as far
    // as the search went: an error of 1e-4 costs 3e-7.
    for (const ProfilePoint& point : a.points) {
      EXPECT_NEAR(point.x[1], 0.8 - (point.x[0] - 2.2) / 3.0, 1e-4);
    }
  }
}

/// A cost that is flat up to a wall: the end is at the wall, not where the points ran out.
TEST(Profile, FindsAWallBehindAFlatStretch) {
  for (const double wall : {1.5, 4.0, 7.3}) {
    const LeastSquaresProblem flat =
        problem_of(1, 1, [wall](std::span<const double> x, std::span<double> r) {
          r[0] = 1e3 * std::max(0.0, std::fabs(x[0]) - wall);
          return true;
        });
    ProfileStart best;
    best.x = {0.1};
    best.value = 0.1;
    const ProfileSide up = profile_coordinate(flat, best, 0, true, kTwoErrors);
    EXPECT_EQ(up.why, ProfileEnd::Crossed);
    EXPECT_NEAR(up.end, wall + 2e-3, 1e-2) << up.points.size();
  }
}

TEST(Profile, DoesNotDependOnTheCoordinate) {
  // The line again, its intercept searched by its logarithm: asymmetric, but the same interval.
  const LeastSquaresProblem in_logarithm =
      problem_of(2, 5, [](std::span<const double> x, std::span<double> r) {
        const std::vector<double> at{std::exp(x[0]), x[1]};
        bool found = false;
        line().evaluate(at, r, {&found, 1});
        return found;
      });
  const double low = side(in_logarithm, 0, false).end, high = side(in_logarithm, 0, true).end;
  EXPECT_NEAR(std::exp(low), 2.2 - 2.0 * std::sqrt(0.6), 1e-4);
  EXPECT_NEAR(std::exp(high), 2.2 + 2.0 * std::sqrt(0.6), 1e-4);
  EXPECT_GT(std::log(2.2) - low, 2.0 * (high - std::log(2.2)));
}

TEST(Profile, EndsAtABoundThatItReaches) {
  LeastSquaresProblem problem = line();
  problem.lower[0] = problem.start[0] = 1.5;
  const ProfileSide low = side(problem, 0, false);
  EXPECT_EQ(low.why, ProfileEnd::Bound);
  EXPECT_EQ(low.end, 1.5);
  EXPECT_EQ(side(problem, 0, true).why, ProfileEnd::Crossed);
}

TEST(Profile, HasOneSideOfASolutionAtABound) {
  // The least cost for a = 2: 0.04/0.6 above the least of all.
  LeastSquaresProblem problem = line();
  problem.upper[0] = 2.0;
  const ProfileSide high = side(problem, 0, true), low = side(problem, 0, false);
  EXPECT_EQ(high.why, ProfileEnd::Bound);
  EXPECT_EQ(high.end, 2.0);
  EXPECT_TRUE(high.points.empty());
  EXPECT_NEAR(low.end, 2.2 - std::sqrt(0.6 * (4.0 + 0.04 / 0.6)), 1e-5);
}

TEST(Profile, IsOpenWhereOnlyACombinationIsDetermined) {
  LeastSquaresProblem problem =
      problem_of(2, 2, [](std::span<const double> x, std::span<double> r) {
        r[0] = x[0] + x[1] - 3.0;
        r[1] = 2.0 * (x[0] + x[1]) - 6.5;
        return true;
      });
  // The other one follows between its bounds.
  problem.lower[0] = 0.0;
  problem.upper[0] = 3.0;
  const ProfileSide low = side(problem, 0, false), high = side(problem, 0, true);
  EXPECT_EQ(low.why, ProfileEnd::Bound);
  EXPECT_EQ(low.end, 0.0);
  EXPECT_EQ(high.why, ProfileEnd::Bound);
  EXPECT_EQ(high.end, 3.0);
}

TEST(Profile, EndsWhereThereAreNoCurves) {
  const LeastSquaresProblem problem =
      problem_of(1, 2, [](std::span<const double> x, std::span<double> r) {
        r[0] = 0.1 * x[0];
        r[1] = 1.0;
        return x[0] < 3.0;
      });
  const ProfileSide high = side(problem, 0, true);
  EXPECT_EQ(high.why, ProfileEnd::NoCurves);
  EXPECT_NEAR(high.end, 3.0, 0.01);
}

/// Squares about (1, 2) with standard errors of 1 in all directions, and a function of them.
LeastSquaresProblem ball(double (*function)(double, double)) {
  return problem_of(2, 3, [function](std::span<const double> x, std::span<double> r) {
    r[0] = x[0] - 1.0;
    r[1] = x[1] - 2.0;
    r[2] = function(x[0], x[1]);
    return true;
  });
}

ProfileStart ball_start(double value, double step) { return {{1.0, 2.0}, 0.0, value, step, {}}; }

TEST(Profile, OfALinearFunctionIsThatOfItsCovariance) {
  const LeastSquaresProblem problem = ball([](double a, double b) { return 3.0 * a + 4.0 * b; });
  for (const bool up : {false, true}) {
    const ProfileSide found = profile_function(problem, ball_start(11.0, 9.0), up, kTwoErrors);
    EXPECT_EQ(found.why, ProfileEnd::Crossed);
    EXPECT_NEAR(found.end, 11.0 + (up ? 10.0 : -10.0), 1e-4);
  }
}

TEST(Profile, OfAFunctionIsItsRangeOverTheLikelihoodRegion) {
  // Over a disc of radius 2 about a point at the distance sqrt(5): (sqrt(5) +- 2)^2.
  const LeastSquaresProblem problem = ball([](double a, double b) { return a * a + b * b; });
  const double low = std::sqrt(5.0) - 2.0, high = std::sqrt(5.0) + 2.0;
  EXPECT_NEAR(profile_function(problem, ball_start(5.0, 9.0), true, kTwoErrors).end, high * high,
              2e-3);
  EXPECT_NEAR(profile_function(problem, ball_start(5.0, 9.0), false, kTwoErrors).end, low * low,
              2e-3);
}

TEST(Profile, OfAFunctionIsOpenWhereItGoesNoFurther) {
  // Within 1 of 0 whatever the coordinates are.
  const LeastSquaresProblem problem =
      ball([](double a, double) { return std::tanh(0.2 * (a - 1.0)); });
  ProfileOptions far = kTwoErrors;
  far.rise = 400.0;
  const ProfileSide high = profile_function(problem, ball_start(0.0, 4.0), true, far);
  EXPECT_EQ(high.why, ProfileEnd::Open);
  EXPECT_GT(high.end, 0.9);
  EXPECT_LT(high.end, 1.0);
}

}  // namespace
}  // namespace plastica::calibrate
