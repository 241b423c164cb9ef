#include "calibrate/search/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plastica::calibrate {
namespace {

/// Rosenbrock's valley as residuals: 10 (x1 - x0^2), 1 - x0.
LeastSquaresProblem valley() {
  LeastSquaresProblem problem;
  problem.lower = {-5.0, -5.0};
  problem.upper = {5.0, 5.0};
  problem.start = {-1.2, 1.0};
  problem.residuals = 2;
  problem.evaluate = one_by_one([](std::span<const double> x, std::span<double> r) {
    r[0] = 10.0 * (x[1] - x[0] * x[0]);
    r[1] = 1.0 - x[0];
    return true;
  });
  return problem;
}

TEST(LeastSquares, HasSlopesOfOneSideWhereTheOtherHasNoResiduals) {
  LeastSquaresProblem problem = valley();
  problem.evaluate = one_by_one([](std::span<const double> x, std::span<double> r) {
    r[0] = 3.0 * x[0];
    r[1] = x[1];
    return x[0] <= 1.0;
  });
  const std::vector<double> x{1.0, 2.0};
  const auto slopes = residual_slopes(problem, x, std::vector<double>{3.0, 2.0}, 1e-4);
  EXPECT_NEAR(slopes[0], 3.0, 1e-9);
  EXPECT_NEAR(slopes[3], 1.0, 1e-9);
}

TEST(LeastSquares, GoesDownACurvedValley) {
  const LeastSquares found = minimize_squares(valley(), {});
  EXPECT_NEAR(found.x[0], 1.0, 1e-8);
  EXPECT_NEAR(found.x[1], 1.0, 1e-8);
  EXPECT_LT(found.cost, 1e-16);
  EXPECT_LT(found.evaluations, 120);
}

TEST(LeastSquares, HoldsWhatABoundStops) {
  LeastSquaresProblem problem = valley();
  problem.upper = {0.5, 5.0};
  problem.start = {-1.2, 1.0};
  const LeastSquares found = minimize_squares(problem, {});
  EXPECT_EQ(found.x[0], 0.5);
  EXPECT_NEAR(found.x[1], 0.25, 1e-8);
  EXPECT_NEAR(found.cost, 0.25, 1e-12);
}

TEST(LeastSquares, FindsTheLeastOfWhatCannotVanish) {
  // A line through points that are on none: 2.2 + 0.8 t, by the normal equations.
  LeastSquaresProblem problem;
  problem.lower = {-100.0, -100.0};
  problem.upper = {100.0, 100.0};
  problem.start = {0.0, 0.0};
  problem.residuals = 5;
  problem.evaluate = one_by_one([](std::span<const double> x, std::span<double> r) {
    const double y[] = {2.0, 3.0, 4.5, 4.0, 5.5};
    for (std::size_t i = 0; i < 5; ++i) r[i] = x[0] + x[1] * static_cast<double>(i) - y[i];
    return true;
  });
  const LeastSquares found = minimize_squares(problem, {});
  EXPECT_NEAR(found.x[0], 2.2, 1e-7);
  EXPECT_NEAR(found.x[1], 0.8, 1e-7);
  const auto slopes = residual_slopes(problem, found.x, found.residual, 1e-4);
  EXPECT_NEAR(slopes[2 * 4 + 0], 1.0, 1e-9);
  EXPECT_NEAR(slopes[2 * 4 + 1], 4.0, 1e-9);
}

TEST(LeastSquares, StepsBackFromWhereThereIsNothing) {
  LeastSquaresProblem problem;
  problem.lower = {1e-3};
  problem.upper = {10.0};
  problem.start = {0.1};
  problem.residuals = 1;
  int missing = 0;
  problem.evaluate = one_by_one([&](std::span<const double> x, std::span<double> r) {
    if (x[0] > 4.0) ++missing;
    r[0] = 1.0 / x[0] - 1.0 / 3.0;
    return x[0] <= 4.0;
  });
  const LeastSquares found = minimize_squares(problem, {});
  EXPECT_NEAR(found.x[0], 3.0, 1e-7);
  problem.start = {3.9999999};  // ahead of it a difference finds nothing
  EXPECT_NEAR(minimize_squares(problem, {}).x[0], 3.0, 1e-7);
  EXPECT_GT(missing, 0);
}

TEST(LeastSquares, SaysHowItEnded) {
  LeastSquaresProblem problem = valley();
  const LeastSquares few = minimize_squares(problem, {.max_evaluations = 7});
  EXPECT_EQ(few.outcome, LeastSquaresOutcome::EvaluationsReached);
  EXPECT_LE(few.evaluations, 7);
  EXPECT_EQ(name_of(few.outcome), "evaluations-reached");
  problem.evaluate = one_by_one([](std::span<const double>, std::span<double>) { return false; });
  EXPECT_EQ(minimize_squares(problem, {}).outcome, LeastSquaresOutcome::NoStart);
  for (const double slope : residual_slopes(problem, problem.start, std::vector<double>(2), 1e-4)) {
    EXPECT_TRUE(std::isnan(slope));
  }
  problem.evaluate = one_by_one([](std::span<const double>, std::span<double>) -> bool {
    throw std::runtime_error("out of paper");
  });
  EXPECT_THROW(minimize_squares(problem, {}), std::runtime_error);
}

TEST(LeastSquares, KnowWhichPointsLieBeside) {
  const std::vector<double> points{1.0,        2.0,        1.0 + 1e-4, 2.0, 1.0, 2.1,
                                   1.0 + 1e-4, 2.1 - 1e-5, 1.0,        2.0, NAN, 2.0};
  EXPECT_EQ(leads_among(points, 6), (std::vector<std::size_t>{0, 0, 2, 2, 0, 5}));
  EXPECT_TRUE(leads_among({}, 0).empty());
}

/// The same problem whose points beside the first one cost little: where that has no residuals
/// they have none.
LeastSquaresProblem with_companions(LeastSquaresProblem problem) {
  problem.has_companions = true;
  problem.evaluate = [evaluate = problem.evaluate](std::span<const double> points,
                                                   std::span<double> residuals,
                                                   std::span<bool> found) {
    for (const std::size_t lead : leads_among(points, found.size())) EXPECT_EQ(lead, 0U);
    evaluate(points, residuals, found);
    for (bool& one : found) one = one && found[0];
  };
  return problem;
}

/// The slopes come with the points, and the way down is the same.
TEST(LeastSquares, TakeTheSameWayWithCompanions) {
  LeastSquaresProblem bounded = valley();
  bounded.upper = {0.5, 5.0};
  LeastSquaresProblem beside_nothing = valley();  // a difference ahead finds nothing
  beside_nothing.evaluate = one_by_one([](std::span<const double> x, std::span<double> r) {
    r[0] = 10.0 * (x[1] - x[0] * x[0]);
    r[1] = 1.0 - x[0];
    return x[1] <= 1.0;
  });
  for (const LeastSquaresProblem& problem : {valley(), bounded, beside_nothing}) {
    const LeastSquares alone = minimize_squares(problem, {});
    const LeastSquares found = minimize_squares(with_companions(problem), {});
    EXPECT_EQ(found.x, alone.x);
    EXPECT_EQ(found.residual, alone.residual);
    EXPECT_EQ(found.outcome, alone.outcome);
    EXPECT_EQ(residual_slopes(with_companions(problem), found.x, found.residual, 1e-4),
              residual_slopes(problem, found.x, found.residual, 1e-4));
  }
  // … however few points there may be: slopes count where they are used.
  for (int most = 1; most < 40; ++most) {
    const LeastSquares alone = minimize_squares(valley(), {.max_evaluations = most});
    const LeastSquares few = minimize_squares(with_companions(valley()), {.max_evaluations = most});
    EXPECT_LE(few.evaluations, most);
    EXPECT_EQ(few.x, alone.x) << most;
    EXPECT_EQ(few.outcome, alone.outcome) << most;
  }
}

}  // namespace
}  // namespace plastica::calibrate
