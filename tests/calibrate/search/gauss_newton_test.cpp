#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "calibrate/search/gauss_newton.hpp"
#include "calibrate/search/marquardt_steps.hpp"
#include "calibrate/search/optimizer.hpp"

namespace plastica::calibrate {
namespace {

/// Rosenbrock's valley: r = (10 (x1 - x0^2), 1 - x0).
double valley(std::span<const double> x, std::span<double> gradient, std::span<double> normal) {
  const double r[] = {10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]};
  const double slope = -20.0 * x[0];
  gradient[0] = slope * r[0] - r[1];
  gradient[1] = 10.0 * r[0];
  normal[0] = slope * slope + 1.0;
  normal[1] = normal[2] = 10.0 * slope;
  normal[3] = 100.0;
  return r[0] * r[0] + r[1] * r[1];
}

Problem valley_problem() { return {{-5.0, -5.0}, {5.0, 5.0}, {-1.2, 1.0}, nullptr, valley}; }

Minimum descend(const Problem& problem, int evaluations = 200) {
  MinimizeOptions options;
  options.algorithm = kGaussNewton;
  options.max_evaluations = evaluations;
  return minimize(problem, options);
}

TEST(GaussNewton, IsAStageAsAnyOther) {
  EXPECT_EQ(std::ranges::count(algorithm_names(), kGaussNewton), 1);
  EXPECT_FALSE(is_global(kGaussNewton));
  EXPECT_TRUE(needs_gradient(kGaussNewton));
}

TEST(GaussNewton, GoesDownACurvedValleyInFewEvaluations) {
  const Minimum found = descend(valley_problem());
  EXPECT_TRUE(found.usable);
  EXPECT_NEAR(found.x[0], 1.0, 1e-10);
  EXPECT_NEAR(found.x[1], 1.0, 1e-10);
  EXPECT_LT(found.cost, 1e-20);
  EXPECT_LT(found.evaluations, 60);
  EXPECT_LT(found.promised, 1e-20);
}

TEST(GaussNewton, GoesOnWhereItWasLeft) {
  const Problem problem = valley_problem();
  const Minimum at_once = descend(problem);
  GaussNewton search(problem, problem.start, {});
  int evaluations = 0;
  Minimum end;
  while (!search.ended()) {
    end = search.advance(3);
    EXPECT_LE(end.evaluations, 3);
    evaluations += end.evaluations;
  }
  EXPECT_EQ(end.x, at_once.x);
  EXPECT_EQ(end.cost, at_once.cost);
  EXPECT_EQ(end.outcome, at_once.outcome);
  EXPECT_EQ(evaluations, at_once.evaluations);
}

TEST(GaussNewton, StopsAtAnActiveBound) {
  Problem problem = valley_problem();
  problem.upper[0] = 0.5;
  const Minimum found = descend(problem);
  EXPECT_EQ(found.x[0], 0.5);
  EXPECT_NEAR(found.x[1], 0.25, 1e-8);
  EXPECT_NEAR(found.cost, 0.25, 1e-12);
  EXPECT_LT(found.promised, 1e-12);
}

TEST(GaussNewton, KeepsTheLargestNumberOfEvaluations) {
  for (const int most : {1, 2, 7}) {
    const Minimum found = descend(valley_problem(), most);
    EXPECT_EQ(found.evaluations, most);
    EXPECT_EQ(found.outcome, "maxeval-reached");
    EXPECT_TRUE(found.usable);
    EXPECT_GT(found.promised, 0.0);
  }
}

TEST(GaussNewton, StepsBackFromWhereThereIsNoCost) {
  Problem problem = valley_problem();
  problem.squares = [](std::span<const double> x, std::span<double> gradient,
                       std::span<double> normal) {
    const double cost = valley(x, gradient, normal);
    return x[1] < -2.0 ? std::numeric_limits<double>::infinity() : cost;
  };
  EXPECT_NEAR(descend(problem).x[1], 1.0, 1e-9);
  problem.start = {0.0, -3.0};
  const Minimum nothing = descend(problem);
  EXPECT_FALSE(nothing.usable);
  EXPECT_TRUE(nothing.x.empty());
  EXPECT_EQ(nothing.outcome, "failure");
}

TEST(GaussNewton, EndsEarlyOnAKinkAndSaysWhatItsSlopesPromise) {
  // r = (1 + |x|, y - 1): least at (0, 1), where either side's slope promises a decrease of 1.
  Problem problem = valley_problem();
  problem.squares = [](std::span<const double> x, std::span<double> gradient,
                       std::span<double> normal) {
    const double side = x[0] < 0.0 ? -1.0 : 1.0;
    const double r[] = {1.0 + std::fabs(x[0]), x[1] - 1.0};
    gradient[0] = side * r[0];
    gradient[1] = r[1];
    normal[0] = normal[3] = 1.0;
    normal[1] = normal[2] = 0.0;
    return r[0] * r[0] + r[1] * r[1];
  };
  const Minimum found = descend(problem);
  EXPECT_EQ(found.outcome, "stalled");
  EXPECT_LT(found.evaluations, 50);
  EXPECT_GT(found.promised, 0.5);
}

/// Beside one more unknown that nothing moves, which is solved another way, steps are the same.
TEST(MarquardtSteps, OfOneAndTwoUnknownsAreThoseOfMore) {
  const auto step_of = [](const Eigen::VectorXd& gradient, const Eigen::MatrixXd& normal,
                          Eigen::Index more) {
    const Eigen::Index n = gradient.size(), all = n + more;
    SquaresModel model{1.0, Eigen::VectorXd::Zero(all), Eigen::MatrixXd::Identity(all, all)};
    model.gradient.head(n) = gradient;
    model.normal.topLeftCorner(n, n) = normal;
    const Eigen::VectorXd far = Eigen::VectorXd::Constant(all, 1e9);
    MarquardtSteps steps(-far, far, {});
    EXPECT_FALSE(steps.propose(Eigen::VectorXd::Zero(all), model));
    return Eigen::VectorXd(steps.step().head(n));
  };
  const auto expect_alike = [&](const Eigen::VectorXd& gradient, const Eigen::MatrixXd& normal) {
    const Eigen::VectorXd own = step_of(gradient, normal, 0), more = step_of(gradient, normal, 2);
    EXPECT_LT((own - more).norm(), 1e-12 * more.norm()) << own << " and " << more;
  };
  expect_alike(Eigen::VectorXd::Constant(1, 0.3), Eigen::MatrixXd::Constant(1, 1, 4.0));
  const Eigen::VectorXd gradient{{0.3, -0.2}};
  for (const double size : {1e-3, 1.0, 1e3}) {  // either pivot is the larger one
    expect_alike(gradient, Eigen::MatrixXd{{4.0, 1.9 * size}, {1.9 * size, size * size}});
  }
  // Of two alike Marquardt's damping makes one step of both.
  const Eigen::VectorXd both =
      step_of(Eigen::VectorXd::Constant(2, 0.3), Eigen::MatrixXd::Constant(2, 2, 1.0), 0);
  EXPECT_NEAR(both[0], -0.3 / 2.001, 1e-12);
  EXPECT_NEAR(both[1], both[0], 1e-12);
}

TEST(GaussNewton, CarriesAnExceptionOut) {
  Problem problem = valley_problem();
  problem.squares = [](auto, auto, auto) -> double { throw std::out_of_range("special"); };
  EXPECT_THROW(descend(problem), std::out_of_range);
}

}  // namespace
}  // namespace plastica::calibrate
