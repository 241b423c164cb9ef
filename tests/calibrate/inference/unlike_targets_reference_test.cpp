#include "calibrate/fit/scene_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/calibrate/inference/elastic_cantilever.hpp"

// Specimens of scattering modulus that share one: as a mean of them is known.

namespace plastica::calibrate {
namespace {

using testing::kModulus;

constexpr int kSamples = 30;
constexpr double kNoise = 0.006;  // over the largest tip

/// Specimens of a cantilever, each with a modulus of its own.
/// @param unlike  how their noise, and how many samples they have, scatter: as its logarithm
/// @param rho     how alike neighbours' noise is
std::vector<WeightedTarget> specimens(int count, double scatter, std::uint32_t seed,
                                      double unlike = 0.0, double rho = 0.0) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<WeightedTarget> targets;
  for (int k = 0; k < count; ++k) {
    const double noise = kNoise * std::exp(unlike * normal(random));
    const int samples = static_cast<int>(kSamples * std::exp(0.5 * unlike * normal(random))) + 5;
    WeightedTarget one{testing::cantilever(4), testing::continuous()};
    one.target.name = "specimen-" + std::to_string(k + 1);
    const double per_force = one.target.ordinate[0] / one.target.abscissa[0];
    const double own = per_force / (1.0 + scatter * normal(random));
    one.target.abscissa.clear();
    one.target.ordinate.clear();
    double off = normal(random);
    for (int i = 1; i <= samples; ++i) {
      one.target.abscissa.push_back(0.1 * i / samples);
      one.target.ordinate.push_back(own * one.target.abscissa.back() +
                                    noise * 0.1 * per_force * off);
      off = rho * off + std::sqrt(1.0 - rho * rho) * normal(random);
    }
    targets.push_back(std::move(one));
  }
  return targets;
}

/// The continuous beam's modulus as a chain of four segments has it: larger by 1/(2 N^2).
constexpr double kOfChain = kModulus * (1.0 + 1.0 / 32.0);

SceneFitOptions without_segments() {
  SceneFitOptions options = testing::stiffness();
  options.segments_error = false;
  return options;
}

bool says(const SceneFitResult& result, const std::string& words) {
  return std::ranges::any_of(result.warnings, [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

struct Counts {
  int hold = 0, warned = 0, blamed_law = 0;
};

Counts counts_of(int count, double scatter, int seeds, double unlike = 0.0, double rho = 0.0,
                 Objective objective = Objective::LeastSquares) {
  Counts counts;
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto targets = specimens(count, scatter, static_cast<std::uint32_t>(seed), unlike, rho);
    SceneFitOptions options = without_segments();
    options.objective = objective;
    const SceneFitResult result = fit(targets, options);
    const FittedParameter& e = result.parameters.at(0);
    counts.hold += e.interval_low <= kOfChain && kOfChain <= e.interval_high ? 1 : 0;
    counts.warned += says(result, "differ by more than their noise") ? 1 : 0;
    counts.blamed_law += says(result, "does not describe") ? 1 : 0;
  }
  return counts;
}

TEST(UnlikeTargets, OfScatteringSpecimensHaveTheErrorOfTheirMean) {
  // 95 % of 60 are 57 +- 1.7, three of which are allowed. With the noise alone it would be some 25.
  for (const double scatter : {0.01, 0.03}) {
    const Counts counts = counts_of(8, scatter, 60);
    EXPECT_NEAR(counts.hold, 57, 5) << scatter;
    EXPECT_EQ(counts.warned, 60) << scatter;
    EXPECT_EQ(counts.blamed_law, 0) << "each by itself is a straight line";
  }
}

/// The quietest, and the longest, would pull the mean to themselves.
TEST(UnlikeTargets, CountAlikeHoweverUnlikeTheirNoise) {
  for (const int count : {3, 8}) {
    const Counts counts = counts_of(count, 0.03, 60, 1.0);
    EXPECT_NEAR(counts.hold, 57, 5) << count;
    EXPECT_GE(counts.warned, 58) << count;
  }
}

TEST(UnlikeTargets, OfOneModulusAreLeftAsTheyAre) {
  for (const double unlike : {0.0, 1.0}) {
    const Counts counts = counts_of(8, 0.0, 100, unlike);
    EXPECT_NEAR(counts.hold, 95, 6) << unlike;
    EXPECT_LE(counts.warned, 2) << unlike << ": one of a thousand";
  }
}

TEST(UnlikeTargets, AreNotSeenWhereNeighboursAreAlikeOrSamplesCountByTheirPath) {
  // Thirty samples hardly say how alike neighbours are: one in twenty, where it should be one of a
  // thousand.
  for (const double rho : {0.3, 0.5, 0.8}) {
    EXPECT_LE(counts_of(8, 0.0, 60, 0.0, rho).warned, 4) << rho;
  }
  EXPECT_LE(counts_of(8, 0.0, 100, 0.0, 0.0, Objective::Path).warned, 2);
}

/// A scatter of three times what noise does to each: of three specimens it is not seen for sure in
/// a half of the cases, and counts all the same.
TEST(UnlikeTargets, CountBeforeTheyAreSureToDiffer) {
  const Counts counts = counts_of(3, 0.01, 100);
  EXPECT_LT(counts.warned, 90);
  EXPECT_NEAR(counts.hold, 95, 7);
}

/// A prior counts beside specimens by how they scatter, not by their noise: with one of the
/// scatter's own error both have half the weight.
TEST(UnlikeTargets, LeaveAPriorTheWeightThatItHasBesideTheirScatter) {
  const auto targets = specimens(8, 0.03, 5);
  SceneFitOptions options = without_segments();
  const FittedParameter alone = fit(targets, options).parameters.at(0);
  const double error = alone.standard_error;
  options.parameters[0].prior = Prior{alone.value + 2.0 * error, error};
  const SceneFitResult beside = fit(targets, options);
  EXPECT_NEAR((beside.parameters.at(0).value - alone.value) / error, 1.0, 0.3);
  EXPECT_TRUE(says(beside, "of what is known of it, 51 % is the prior's"));
  // Each one's noise is reported as it is.
  for (const TargetFit& one : beside.targets) {
    EXPECT_NEAR(one.noise / (kNoise * targets[0].target.ordinate.back()), 1.0, 0.45);
  }
}

TEST(UnlikeTargets, OfTwoAreTooFewForAnErrorButNotForAWarning) {
  const auto targets = specimens(2, 0.03, 7);
  const SceneFitResult result = fit(targets, without_segments());
  EXPECT_TRUE(says(result, "specimen-1 and specimen-2 differ by more than their noise"));
  EXPECT_TRUE(says(result, "two hardly say how far others would be"));
}

/// The chi-squared of estimates that are known each to s about their mean: sum (E_k - E)^2/s^2.
TEST(UnlikeTargets, AreJudgedByWhatEachAsksFor) {
  const auto targets = specimens(6, 0.02, 11);
  std::vector<double> values;
  double error = 0.0, mean = 0.0;
  for (const WeightedTarget& one : targets) {
    const std::vector<WeightedTarget> alone{one};
    const FittedParameter e = fit(alone, without_segments()).parameters.at(0);
    values.push_back(e.value);
    error += e.noise_error / 6.0;
    mean += e.value / 6.0;
  }
  double squares = 0.0, scatter = 0.0;
  for (const double value : values) {
    squares += std::pow((value - mean) / error, 2);
    scatter += std::pow(value - mean, 2) / 5.0;
  }
  const SceneFitResult all = fit(targets, without_segments());
  const auto said = std::ranges::find_if(all.warnings, [](const std::string& warning) {
    return warning.find("chi-squared") != std::string::npos;
  });
  ASSERT_NE(said, all.warnings.end());
  const double chi_squared = std::stod(said->substr(said->find("chi-squared") + 12));
  // As seldom by chi-squared as by F of 29 degrees, which is less; 20.5 is once in a thousand
  // times.
  EXPECT_LT(chi_squared, squares);
  EXPECT_GT(chi_squared, 20.5);
  EXPECT_NE(said->find("of 5 degrees"), std::string::npos) << *said;
  EXPECT_NEAR(all.parameters.at(0).standard_error, std::sqrt(scatter / 6.0),
              0.3 * std::sqrt(scatter / 6.0));
  EXPECT_LT(all.parameters.at(0).degrees_of_freedom, 8.0);
}

/// Of six samples each noise is not known well enough to compare them by.
TEST(UnlikeTargets, OfFewSamplesAreComparedByHowCloselyTheyAreMet) {
  auto targets = specimens(3, 0.0, 3);
  for (WeightedTarget& one : targets) {
    one.target.abscissa.resize(6);
    one.target.ordinate.resize(6);
  }
  EXPECT_FALSE(says(fit(targets, without_segments()), "met far less closely"));
  for (double& w : targets[2].target.ordinate) w /= 1.5;
  const SceneFitResult result = fit(targets, without_segments());
  EXPECT_FALSE(says(result, "differ by more than their noise"));
  EXPECT_TRUE(says(result, "specimen-3 is met far less closely than specimen-"));
}

}  // namespace
}  // namespace plastica::calibrate
