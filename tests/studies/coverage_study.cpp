// Honest intervals: bilinear curves (stress = 1.5 strain to Y, then with the slope H), fitted
// through a coupon that follows their strain. Specimens of a population give back mean and scatter
// of their parameters; intervals of 95 % hold the truth as often as they say, whichever way they
// are found. PLASTICA_STUDY=full runs 1 000 seeds, =sample the first 40.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "calibrate/report/scene_population.hpp"
#include "plastica/base/parallel_for.hpp"
#include "tests/calibrate/fit/bilinear_coupon.hpp"
#include "tests/support/shared.hpp"

namespace plastica::calibrate {
namespace {

using testing::Bilinear;
using testing::bilinear_coupon;
using testing::bilinear_target;
using testing::noisy_bilinear;
using testing::yield_and_tangent;

bool is_full() {
  const char* study = std::getenv("PLASTICA_STUDY");
  return study != nullptr && std::string(study) == "full";
}

/// Numbers of a CSV file below its header, column by column.
std::vector<std::vector<double>> columns_of(const std::string& path) {
  std::ifstream file(path);
  std::string line, cell;
  std::getline(file, line);
  std::vector<std::vector<double>> columns;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (k == columns.size()) columns.emplace_back();
      columns[k].push_back(std::stod(cell));
    }
  }
  return columns;
}

/// Mean, and covariance with n - 1, of two columns.
struct Moments {
  double mean[2] = {0.0, 0.0};
  double covariance[2][2] = {{0.0, 0.0}, {0.0, 0.0}};

  explicit Moments(const std::vector<std::vector<double>>& columns) {
    const std::size_t n = columns[0].size();
    for (std::size_t k = 0; k < 2; ++k) {
      for (const double v : columns[k]) mean[k] += v / static_cast<double>(n);
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t a = 0; a < 2; ++a) {
        for (std::size_t b = 0; b < 2; ++b) {
          covariance[a][b] +=
              (columns[a][i] - mean[a]) * (columns[b][i] - mean[b]) / static_cast<double>(n - 1);
        }
      }
    }
  }
};

TEST(Coverage, PopulationOfSpecimensIsThatOfTheirTruths) {
  PLASTICA_NEEDS_SHARED("data/synthetic-bilinear");
  const std::string folder = testing::shared_path("data/synthetic-bilinear/");
  const auto samples = columns_of(folder + "uq_200_samples.csv");
  const auto truths = columns_of(folder + "uq_200_true_parameters.csv");
  const std::size_t n = truths[0].size();
  ASSERT_EQ(n, 200U);
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = yield_and_tangent();
  std::vector<SceneFitRecord> records(n);
  std::vector<WeightedTarget> pooled(n);
  parallel_for(n, {}, [&](std::size_t i, int) {
    SceneTarget target = bilinear_target("specimen " + std::to_string(i), samples[i + 1]);
    target.abscissa = samples[0];
    pooled[i] = {bilinear_coupon(), target};
    records[i].name = target.name;
    records[i].result = fit_scene(bilinear_coupon(), target, options);
    records[i].targets = {std::move(target)};
    records[i].weights = {1.0};
  });
  const ScenePopulation population = scene_population(records);
  const Moments truth(truths);
  const char* names[] = {"Y", "H"};
  for (std::size_t k = 0; k < 2; ++k) {
    const PopulationParameter& p = population.parameters[k];
    ASSERT_EQ(p.n, n);
    const double scatter = std::sqrt(truth.covariance[k][k]);
    const double error = scatter / std::sqrt(static_cast<double>(n));
    std::printf(
        "%s: mean %.5f, of the truths %.5f +- %.5f; specimens' variance %.3e, of the truths "
        "%.3e (ratio %.3f); of the values %.3e\n",
        names[k], p.mean, truth.mean[k], error, p.specimen_deviation * p.specimen_deviation,
        truth.covariance[k][k],
        p.specimen_deviation * p.specimen_deviation / truth.covariance[k][k],
        population.covariance[3 * k]);
    EXPECT_NEAR(p.mean, truth.mean[k], 2.0 * error);
    EXPECT_NEAR(population.specimen_covariance[3 * k], truth.covariance[k][k],
                0.1 * truth.covariance[k][k]);
  }
  const double size = std::sqrt(truth.covariance[0][0] * truth.covariance[1][1]);
  std::printf("covariance over sqrt(var Y var H): %.4f, of the truths %.4f\n",
              population.specimen_covariance[1] / size, truth.covariance[0][1] / size);
  EXPECT_NEAR(population.specimen_covariance[1], truth.covariance[0][1], 0.05 * size);

  // What one fit of all curves says: how well their mean is known, nothing of their scatter.
  options.threads = 0;
  const SceneFitResult one = fit(pooled, options);
  ASSERT_EQ(one.status, FitStatus::Fitted) << one.reason;
  for (std::size_t k = 0; k < 2; ++k) {
    const FittedParameter& p = one.parameters[k];
    const double scatter = std::sqrt(truth.covariance[k][k]);
    std::printf(
        "%s of one fit of all: %.5f, standard error %.2e, %.3f of the specimens' deviation\n",
        names[k], p.value, p.standard_error, p.standard_error / scatter);
    EXPECT_LT(p.standard_error, 0.1 * scatter);
  }
}

/// Which intervals of a fit hold the truth.
struct Held {
  bool covariance = false, profile = false, bootstrap = false;
};

TEST(Coverage, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const std::size_t seeds = is_full() ? 1000 : 40;
  constexpr Bilinear kTruth;
  const double truth[] = {kTruth.yield_stress, kTruth.tangent_modulus};
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = yield_and_tangent();
  options.intervals = {.profile = true, .bootstrap = is_full() ? 400 : 200};
  std::vector<Held> held(2 * seeds);
  parallel_for(seeds, {}, [&](std::size_t seed, int) {
    const SceneTarget target = noisy_bilinear(kTruth, 0.005, 1000 + seed);
    const SceneFitResult result = fit_scene(bilinear_coupon(), target, options);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto holds = [&](double low, double high) {
        return low <= truth[k] && truth[k] <= high;
      };
      const FittedParameter& p = result.parameters.at(k);
      const LikelihoodProfile& profile = result.intervals.profiles.at(k);
      const BootstrapInterval& bootstrap = result.intervals.residuals.intervals.at(k);
      held[2 * seed + k] = {holds(p.interval_low, p.interval_high),
                            holds(profile.low, profile.high), holds(bootstrap.low, bootstrap.high)};
    }
  });
  const auto fraction = [&](bool Held::*kind, std::size_t k) {
    double count = 0.0;
    for (std::size_t seed = 0; seed < seeds; ++seed) count += held[2 * seed + k].*kind ? 1.0 : 0.0;
    return count / static_cast<double>(seeds);
  };
  // Of 40 seeds 33 hold it or more with a probability of 99.6 %.
  const double low = is_full() ? 0.93 : 33.0 / 40.0;
  const double high = is_full() ? 0.97 : 1.0;
  const double wider = is_full() ? 0.01 : 0.0;
  for (const std::size_t k : {0U, 1U}) {
    const double covariance = fraction(&Held::covariance, k);
    const double profile = fraction(&Held::profile, k);
    const double bootstrap = fraction(&Held::bootstrap, k);
    std::printf("%s: covariance %.1f %%, profile %.1f %%, bootstrap %.1f %% of %zu seeds\n",
                k == 0 ? "Y" : "H", 100.0 * covariance, 100.0 * profile, 100.0 * bootstrap, seeds);
    EXPECT_GE(covariance, low);
    EXPECT_LE(covariance, high);
    EXPECT_GE(profile, low);
    EXPECT_LE(profile, high);
    EXPECT_GE(bootstrap, low - wider);
    EXPECT_LE(bootstrap, high + wider);
  }
}

/// A target with so many samples up to a strain, and noise.
struct Tested {
  int samples = 0;
  double strain = 1.0, noise = 0.0;
};

/// Targets of unlike size and noise that share the parameters.
struct Joint {
  const char* name;
  std::vector<Tested> targets;
};

SceneTarget measured(const Tested& tested, const Bilinear& truth, std::uint64_t seed,
                     std::uint64_t index) {
  Draws draws(seed, index);
  SceneTarget target =
      bilinear_target("target " + std::to_string(index),
                      std::vector<double>(static_cast<std::size_t>(tested.samples)));
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    target.abscissa[i] *= tested.strain;
    target.ordinate[i] =
        testing::bilinear_stress(truth, target.abscissa[i]) + tested.noise * draws.normal();
  }
  return target;
}

TEST(Coverage, JointFitsHoldTheTruthWhoeverDeterminesIt) {
  const std::size_t seeds = is_full() ? 1000 : 40;
  constexpr Bilinear kTruth;
  const double truth[] = {testing::kBilinearModulus, kTruth.yield_stress, kTruth.tangent_modulus};
  // The first target of the first case does not yield: who has 12 samples determines Y and H.
  const Joint cases[] = {{"1000 elastic and 12", {{1000, 0.08, 0.005}, {12, 1.0, 0.005}}},
                         {"100 and 12", {{100, 1.0, 0.005}, {12, 1.0, 0.001}}},
                         {"100 and 4", {{100, 1.0, 0.005}, {4, 1.0, 0.005}}}};
  SceneFitOptions options;
  options.starts = 1;
  options.parameters = yield_and_tangent();
  options.parameters.insert(options.parameters.begin(),
                            testing::bounded("youngs_modulus", 0.5, 5.0));
  options.intervals = {.profile = true};
  for (const Joint& joint : cases) {
    std::vector<Held> held(3 * seeds);
    parallel_for(seeds, {}, [&](std::size_t seed, int) {
      std::vector<WeightedTarget> targets;
      for (std::size_t t = 0; t < joint.targets.size(); ++t) {
        targets.push_back({bilinear_coupon(), measured(joint.targets[t], kTruth, 5000 + seed, t)});
      }
      const SceneFitResult result = fit(targets, options);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto holds = [&](double low, double high) {
          return low <= truth[k] && truth[k] <= high;
        };
        const FittedParameter& p = result.parameters.at(k);
        const LikelihoodProfile& profile = result.intervals.profiles.at(k);
        held[3 * seed + k].covariance = holds(p.interval_low, p.interval_high);
        held[3 * seed + k].profile = holds(profile.low, profile.high);
      }
    });
    const char* names[] = {"E", "Y", "H"};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto fraction = [&](bool Held::*kind) {
        double count = 0.0;
        for (std::size_t seed = 0; seed < seeds; ++seed) {
          count += held[3 * seed + k].*kind ? 1.0 : 0.0;
        }
        return count / static_cast<double>(seeds);
      };
      const double covariance = fraction(&Held::covariance), profile = fraction(&Held::profile);
      std::printf("%s, %s: covariance %.1f %%, profile %.1f %% of %zu seeds\n", joint.name,
                  names[k], 100.0 * covariance, 100.0 * profile, seeds);
      for (const double held_by : {covariance, profile}) {
        EXPECT_GE(held_by, is_full() ? 0.93 : 33.0 / 40.0);
        EXPECT_LE(held_by, is_full() ? 0.97 : 1.0);
      }
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
