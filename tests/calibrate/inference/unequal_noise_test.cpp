#include "calibrate/inference/unequal_noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdint>

#include "calibrate/fit/fit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Two levels, of a few samples and of many, with their own noise each.
struct TwoLevels {
  MatrixXd slopes;
  VectorXd values;
};

TwoLevels two_levels(Index few, Index many, double noise_of_few, std::uint64_t seed) {
  Noise noise(seed);
  TwoLevels made{MatrixXd::Zero(few + many, 2), VectorXd(few + many)};
  for (Index i = 0; i < few + many; ++i) {
    made.slopes(i, i < few ? 0 : 1) = i < few ? 0.5 + 0.5 * static_cast<double>(i % 2) : 1.0;
    made.values(i) = noise(i < few ? noise_of_few : 1.0);
  }
  return made;
}

/// Least squares with equal weights.
FitInfluence fit_to(const MatrixXd& slopes, const VectorXd& values) {
  const MatrixXd inverse = (slopes.transpose() * slopes).inverse();
  FitInfluence fit;
  fit.influence = slopes * inverse;
  fit.leverage = (slopes * inverse).cwiseProduct(slopes).rowwise().sum();
  fit.left = 1.0 - fit.leverage.array();
  fit.residual = slopes * (fit.influence.transpose() * values) - values;
  return fit;
}

// A fit without sample i is off the whole one by its influence times r_i/(1 - h_i): the sandwich is
// what leaving out each sample in turn moves the parameters by, a truth that knows no leverage.
TEST(UnequalNoise, IsWhatLeavingOutEachSampleMoves) {
  const TwoLevels levels = two_levels(6, 20, 5.0, 3);
  const FitInfluence fit = fit_to(levels.slopes, levels.values);
  const MatrixXd covariance =
      fit.influence.transpose() * own_variances(fit).asDiagonal() * fit.influence;
  const VectorXd all = fit.influence.transpose() * levels.values;
  MatrixXd moved = MatrixXd::Zero(2, 2);
  const Index n = levels.values.size();
  for (Index out = 0; out < n; ++out) {
    MatrixXd slopes(n - 1, 2);
    VectorXd values(n - 1);
    for (Index i = 0, k = 0; i < n; ++i) {
      if (i == out) continue;
      slopes.row(k) = levels.slopes.row(i);
      values(k++) = levels.values(i);
    }
    const VectorXd without = slopes.colPivHouseholderQr().solve(values) - all;
    moved += without * without.transpose();
  }
  EXPECT_LT((covariance - moved).norm(), tolerance(1e-10 * moved.norm()));
}

/// In how many of 1000 draws noise is called unequal.
int called_unequal(Index few, Index many, double noise_of_few) {
  int count = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const TwoLevels levels = two_levels(few, many, noise_of_few, 100 + seed);
    count += is_noise_unequal(fit_to(levels.slopes, levels.values)) ? 1 : 0;
  }
  return count;
}

TEST(UnequalNoise, IsFoundWhereItIsAndSeldomWhereItIsNot) {
  // One of a hundred by chance, at the most: the binomial's standard deviation is 3.1.
  EXPECT_LE(called_unequal(40, 120, 1.0), 10 + 10);
  EXPECT_LE(called_unequal(8, 22, 1.0), 10 + 10);
  // A ratio of the variances of 9: its logarithm scatters by sqrt(2/40 + 2/120) = 0.26.
  EXPECT_GE(called_unequal(40, 120, 3.0), 995);
  EXPECT_GE(called_unequal(40, 120, 1.0 / 3.0), 995);
}

TEST(UnequalNoise, OfFewSamplesOrNoneIsNotJudged) {
  const TwoLevels levels = two_levels(3, 8, 100.0, 5);
  EXPECT_FALSE(is_noise_unequal(fit_to(levels.slopes, levels.values)));
  const TwoLevels exact = two_levels(40, 120, 0.0, 5);
  EXPECT_FALSE(is_noise_unequal(fit_to(exact.slopes, 0.0 * exact.values)));
}

// n equal terms: of normal residuals a variance with n degrees of freedom has terms whose squares
// are 3 times their mean's.
TEST(UnequalNoise, HasTheDegreesOfFreedomOfItsTerms) {
  VectorXd squares(3000);
  Noise noise(8);
  for (double& value : squares) value = std::pow(noise(1.0), 2);
  const VectorXd alike = VectorXd::Ones(3000);
  // The fourth moment of 3000 normal numbers scatters by 6 %.
  EXPECT_NEAR(degrees_of_own(alike, squares, 1e9), 3000.0, 4.0 * 0.06 * 3000.0);
  EXPECT_EQ(degrees_of_own(alike, squares, 157.0), 157.0);
  EXPECT_EQ(degrees_of_own(VectorXd::Ones(1), alike.head(1), 157.0), 3.0);
}

// What is resampled keeps the noise of its part of the curve, and the profile is stretched.
TEST(UnequalNoise, IsSeenByBootstrapAndProfileAlike) {
  const std::vector<double> strain = path({0.0014, 0.012}, 60);
  Target target = target_of(strain, ideal_curve(strain, 200e9, 300e6));
  Noise of_stress(7), of_strain(9);
  for (double& s : target.corrected.stress) s += of_stress(1e6);
  for (double& e : target.corrected.strain) e += of_strain(3e-5);
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  options.intervals.bootstrap = 400;
  options.intervals.profile = true;
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.status, FitStatus::Fitted);
  for (std::size_t k = 0; k < 2; ++k) {
    const FittedParameter& p = result.parameters[k];
    // The standard deviation of 400 resamples scatters by 3.5 %.
    EXPECT_NEAR(result.intervals.residuals.intervals[k].standard_error / p.standard_error, 1.0,
                tolerance(4.0 * 0.035));
    const double wide = p.interval_high - p.interval_low;
    const LikelihoodProfile& profile = result.intervals.profiles[k];
    EXPECT_NEAR((profile.high - profile.low) / wide, 1.0, tolerance(0.1)) << p.path;
  }
}

}  // namespace
}  // namespace plastica::calibrate
