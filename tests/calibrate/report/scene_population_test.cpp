#include "calibrate/report/scene_population.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/calibrate/report/scene_records.hpp"

namespace plastica::calibrate {
namespace {

using testing::failed_scene_record;
using testing::lone_scene_record;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A fit whose parameters have these values, errors of 3 and 0.4 and a correlation of -0.5.
SceneFitRecord specimen(double a, double b) {
  SceneFitRecord record = lone_scene_record("s", a, b);
  record.result.parameters[0].noise_error = 3.0;
  record.result.parameters[1].noise_error = 0.4;
  record.result.correlation = {1.0, -0.5, -0.5, 1.0};
  return record;
}

TEST(ScenePopulation, TakesTheMeanSquaredErrorsOutOfTheVariances) {
  const ScenePopulation p = scene_population(
      std::vector{specimen(90.0, 1.0), specimen(100.0, 4.0), specimen(110.0, 7.0)});
  ASSERT_EQ(p.parameters.size(), 2U);
  EXPECT_EQ(p.parameters[0].n, 3U);
  EXPECT_NEAR(p.parameters[0].mean, 100.0, 1e-12);
  EXPECT_NEAR(p.parameters[0].standard_deviation, 10.0, 1e-12);
  EXPECT_NEAR(p.parameters[0].rms_error, 3.0, 1e-12);
  EXPECT_NEAR(p.parameters[0].specimen_deviation, std::sqrt(91.0), 1e-12);
  EXPECT_NEAR(p.covariance[1], 30.0, 1e-12);
  EXPECT_NEAR(p.specimen_covariance[0], 91.0, 1e-11);
  EXPECT_NEAR(p.specimen_covariance[3], 9.0 - 0.16, 1e-12);
  // 30 + 0.5 · 3 · 0.4 is more than sqrt(91 · 8.84) = 28.36: held there.
  EXPECT_NEAR(p.specimen_covariance[1], std::sqrt(91.0 * 8.84), 1e-11);
  EXPECT_NEAR(p.correlation(0, 1), 1.0, 1e-12);
}

TEST(ScenePopulation, LeavesOpenWhereBreaksLieBetweenTheSameSamples) {
  std::vector records{specimen(90.0, 4.0), specimen(100.0, 4.0)};
  for (SceneFitRecord& record : records) {
    record.result.parameters[1].sampling_error = 0.3 / std::sqrt(3.0);
  }
  const ScenePopulation p = scene_population(records);
  EXPECT_NEAR(p.parameters[1].sampling_error, 0.3 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(p.parameters[1].mean_high, 4.0 + 0.95 * 0.3, 1e-9);
  EXPECT_EQ(p.parameters[0].sampling_error, 0.0);
}

/// Values with N/2, N and 2N segments that fall by a fourth each: the continuous beam's is known.
void set_segments(SceneFitRecord& record, std::size_t parameter, double material, double off) {
  FittedParameter& p = record.result.parameters[parameter];
  p.value = material + 4.0 * off;
  record.result.segments->parameters[parameter] =
      segments_error(material + 16.0 * off, p.value, material + off, 2.0);
  p.interval_low = material - 1.0;
  p.interval_high = material + 1.0;
}

TEST(ScenePopulation, IsOfTheMaterialWhereSegmentsLeadToIt) {
  std::vector records{specimen(0.0, 1.0), specimen(0.0, 4.0), specimen(0.0, 7.0)};
  const std::vector<double> materials{90.0, 100.0, 110.0};
  for (std::size_t i = 0; i < 3; ++i) {
    set_segments(records[i], 0, materials[i], 0.02 * materials[i]);
  }
  const ScenePopulation p = scene_population(records);
  EXPECT_TRUE(p.parameters[0].is_of_material);
  EXPECT_NEAR(p.parameters[0].mean, 100.0, 1e-9) << "108 are the beams'";
  EXPECT_NEAR(p.parameters[0].standard_deviation, 10.0, 1e-9);
  EXPECT_GT(p.parameters[0].segments_error, 0.0);
  EXPECT_FALSE(p.parameters[1].is_of_material);
  EXPECT_EQ(p.parameters[1].segments_error, 0.0);
  // Values of the material and of a beam do not mix.
  records[2].result.segments.reset();
  const ScenePopulation mixed = scene_population(records);
  EXPECT_FALSE(mixed.parameters[0].is_of_material);
  EXPECT_NEAR(mixed.parameters[0].mean, 108.0, 1e-9);
}

TEST(ScenePopulation, OfEqualSpecimensIsNoiseAlone) {
  const ScenePopulation p =
      scene_population(std::vector{specimen(99.0, 1.0), specimen(101.0, 1.1)});
  EXPECT_EQ(p.parameters[0].specimen_deviation, 0.0);
  EXPECT_EQ(p.specimen_covariance[1], 0.0);
  EXPECT_TRUE(std::isnan(p.correlation(0, 1)));
}

TEST(ScenePopulation, LeavesOutWhatIsAtABoundOrNotIdentifiedOrFailed) {
  std::vector<SceneFitRecord> records{specimen(90.0, 1.0), specimen(100.0, 4.0),
                                      specimen(110.0, 7.0), specimen(500.0, 9.0),
                                      failed_scene_record("f", "no")};
  records[3].result.parameters[0].at_upper = true;
  records[2].result.parameters[1].noise_error = kNan;
  const ScenePopulation p = scene_population(records);
  EXPECT_EQ(p.parameters[0].n, 3U);
  EXPECT_EQ(p.parameters[0].left_out, 1U);
  EXPECT_NEAR(p.parameters[0].mean, 100.0, 1e-12);
  EXPECT_EQ(p.parameters[1].n, 3U);
  EXPECT_NEAR(p.covariance[1], 15.0, 1e-12) << "of the first two, which determine both";
}

TEST(ScenePopulation, OfOneFitHasNoScatter) {
  const ScenePopulation p = scene_population(std::vector{specimen(90.0, 1.0)});
  EXPECT_EQ(p.parameters[0].mean, 90.0);
  EXPECT_TRUE(std::isnan(p.parameters[0].standard_deviation));
  EXPECT_TRUE(std::isnan(p.parameters[0].specimen_deviation));
  EXPECT_TRUE(scene_population({}).parameters.empty());
}

TEST(ScenePopulation, FindsTheSpecimensScatterUnderNoiseAsLarge) {
  // Truths with deviations 2 and 0.3 and a correlation of 0.6; noise of 3 and 0.4, -0.5.
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto pair = [&](double a, double b, double rho) {
    const double x = normal(random), y = normal(random);
    return std::pair{a * x, b * (rho * x + std::sqrt(1.0 - rho * rho) * y)};
  };
  std::vector<SceneFitRecord> records;
  for (int i = 0; i < 4000; ++i) {
    const auto [a, b] = pair(2.0, 0.3, 0.6);
    const auto [noise_a, noise_b] = pair(3.0, 0.4, -0.5);
    records.push_back(specimen(200.0 + a + noise_a, 20.0 + b + noise_b));
  }
  const ScenePopulation p = scene_population(records);
  // The scatter of such a variance is (s^2 + noise^2) sqrt(2/n): 0.29 of 4, 0.0056 of 0.09; that
  // of the covariance sqrt((13 · 0.25 + 0.24^2)/n) = 0.029. Three of these.
  EXPECT_NEAR(p.specimen_covariance[0], 4.0, 0.87);
  EXPECT_NEAR(p.specimen_covariance[3], 0.09, 0.017);
  EXPECT_NEAR(p.specimen_covariance[1], 0.36, 0.087);
  EXPECT_GT(p.covariance[0], 12.0) << "without taking the noise out";
  EXPECT_LT(p.covariance[1], 0.0) << "likewise";
}

TEST(ScenePopulation, HasIntervalsOfMeanAndScatter) {
  // Forty values without noise: bootstrap-t is near Student's, t(0.975; 39) = 2.023, within 10 %.
  std::mt19937_64 random(3);
  std::normal_distribution<double> scatter(100.0, 10.0);
  std::vector<SceneFitRecord> records;
  for (int i = 0; i < 40; ++i) {
    records.push_back(specimen(scatter(random), i));
    for (FittedParameter& p : records.back().result.parameters) p.noise_error = 0.0;
  }
  const ScenePopulation p = scene_population(records);
  const PopulationParameter& a = p.parameters[0];
  const double wide = 2.0 * 2.023 * a.standard_deviation / std::sqrt(40.0);
  EXPECT_NEAR(a.mean_high - a.mean_low, wide, 0.1 * wide);
  EXPECT_LT(a.mean_low, a.mean);
  EXPECT_GT(a.mean_high, a.mean);
  // The standard error of a normal deviation is about s/sqrt(2 39), here within a third.
  EXPECT_NEAR(a.deviation_high - a.deviation_low, 3.92 * a.standard_deviation / std::sqrt(78.0),
              0.33 * 3.92 * a.standard_deviation / std::sqrt(78.0));
  EXPECT_NEAR(std::sqrt(p.covariance_low[0]), a.deviation_low, 1e-12 * a.deviation_low);
  EXPECT_LT(p.covariance_low[1], p.specimen_covariance[1]);
  EXPECT_GT(p.covariance_high[1], p.specimen_covariance[1]);
  EXPECT_GT(scene_population(records, 0.5).parameters[0].mean_low, a.mean_low);
  records.resize(kMinSpecimens - 1);
  EXPECT_TRUE(std::isnan(scene_population(records).covariance_low[1]));
  EXPECT_TRUE(std::isfinite(scene_population(records).parameters[0].mean_low));
  EXPECT_TRUE(std::isfinite(scene_population(records).parameters[0].deviation_low));
  records.resize(1);
  EXPECT_TRUE(std::isnan(scene_population(records).parameters[0].deviation_low));
}

/// Seven specimens each, of deviation 3, with a noise of 2 of their fits.
TEST(ScenePopulation, HoldsTheDeviationOfFewSpecimensAsOftenAsItSays) {
  constexpr int kPopulations = 400;
  std::mt19937_64 random(5);
  std::normal_distribution<double> scatter(100.0, 3.0), noise(0.0, 2.0);
  int holds = 0, below = 0;
  for (int population = 0; population < kPopulations; ++population) {
    std::vector<SceneFitRecord> records;
    for (int i = 0; i < 7; ++i) {
      records.push_back(specimen(scatter(random) + noise(random), i));
      records.back().result.parameters[0].noise_error = 2.0;
    }
    const PopulationParameter a = scene_population(records).parameters[0];
    holds += a.deviation_low <= 3.0 && a.deviation_high >= 3.0 ? 1 : 0;
    below += a.deviation_high < 3.0 ? 1 : 0;
  }
  // 95 % of 400 are 380 +- 4.4; 10 on each side.
  EXPECT_NEAR(holds, 380, 15);
  EXPECT_NEAR(below, 10, 10);
}

TEST(ScenePopulation, LetsTheDeviationBeNoneWhereTheFitsNoiseIsAll) {
  std::vector<SceneFitRecord> records;
  for (const double value : {99.0, 100.0, 101.0, 100.5}) {
    records.push_back(specimen(value, 1.0));
    records.back().result.parameters[0].noise_error = 1.0;
  }
  const PopulationParameter some = scene_population(records).parameters[0];
  EXPECT_EQ(some.deviation_low, 0.0);
  EXPECT_GT(some.deviation_high, 1.0);
  for (SceneFitRecord& record : records) record.result.parameters[0].noise_error = 10.0;
  EXPECT_EQ(scene_population(records).parameters[0].deviation_high, 0.0);
}

}  // namespace
}  // namespace plastica::calibrate
