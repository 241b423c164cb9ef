#include "calibrate/problem/rising_ideal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "calibrate/problem/misfit.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// A curve of an ideal-plastic bar with noise and weights, some of which are 0.
struct Curves {
  explicit Curves(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> noise;
    const std::size_t n = 1 + random() % 60;
    const double scatter = std::pow(10.0, -12.0 * unit(random));
    double e = random() % 3 == 0 ? -1e-4 * unit(random) : 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      strain.push_back(e);
      stress.push_back(std::min(200e9 * e, 300e6) * (1.0 + scatter * noise(random)));
      weight.push_back(random() % 5 == 0 ? 0.0 : unit(random));
      if (random() % 4 != 0) e += 4e-3 * unit(random) / static_cast<double>(n);
    }
    strain.push_back(e + 1e-4 * unit(random));
  }
  std::vector<double> strain, stress, weight;
};

/// Followed from sample to sample, in twice the precision.
long double squares_of(const Curves& c, double stiffness, double yield) {
  long double plastic = 0.0L, sum = 0.0L;
  for (std::size_t i = 0; i < c.stress.size(); ++i) {
    const long double trial = stiffness * (c.strain[i] - plastic);
    const long double stress =
        std::clamp(trial, -static_cast<long double>(yield), static_cast<long double>(yield));
    plastic = c.strain[i] - stress / stiffness;
    sum += c.weight[i] * (stress - c.stress[i]) * (stress - c.stress[i]);
  }
  return sum;
}

TEST(RisingIdeal, IsTheSumOfAllSamples) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const Curves c(random);
    const auto closed = RisingIdeal::of(c.strain, c.stress, c.weight);
    ASSERT_TRUE(closed);
    // At the curve's own numbers, near to them, and far away.
    const double far = i % 3 == 0 ? 0.0 : std::pow(10.0, -15.0 * unit(random));
    const double stiffness = 200e9 * (1.0 + far * (unit(random) - 0.5));
    const double yield = 300e6 * (1.0 + far * (unit(random) - 0.5));
    const auto sum = closed->sum(stiffness, yield);
    if (stiffness * c.strain.front() < -yield) {
      EXPECT_FALSE(sum);
      continue;
    }
    ASSERT_TRUE(sum);
    const double direct = static_cast<double>(squares_of(c, stiffness, yield));
    // What rounding leaves of stresses, times the residuals: both come from doubles.
    double weights = 0.0;
    for (const double w : c.weight) weights += w;
    const double rounding = 3e-16 * 300e6;
    const double bound = 1e-12 * direct + 4.0 * rounding * std::sqrt(direct * weights) +
                         4.0 * rounding * rounding * weights;
    EXPECT_NEAR(sum->squares, direct, tolerance(bound)) << i;
    EXPECT_GE(sum->squares, 0.0);
  }
}

TEST(RisingIdeal, HasTheSlopesOfTheSum) {
  std::mt19937 random(29);
  for (int i = 0; i < 500; ++i) {
    const Curves c(random);
    const auto closed = RisingIdeal::of(c.strain, c.stress, c.weight);
    const double stiffness = 190e9, yield = 280e6;
    const auto sum = closed->sum(stiffness, yield);
    ASSERT_TRUE(sum);
    double by_stiffness = 0.0, by_yield = 0.0, aa = 0.0, ww = 0.0, size = 0.0;
    for (std::size_t s = 0; s < c.stress.size(); ++s) {
      const bool yields = stiffness * c.strain[s] > yield;
      const double off = std::min(stiffness * c.strain[s], yield) - c.stress[s];
      (yields ? by_yield : by_stiffness) += 2.0 * c.weight[s] * off * (yields ? 1.0 : c.strain[s]);
      (yields ? ww : aa) += c.weight[s] * (yields ? 1.0 : c.strain[s] * c.strain[s]);
      size += c.weight[s] * 600e6;
    }
    EXPECT_NEAR(sum->by_stiffness, by_stiffness, tolerance(1e-14 * size * 2e-3));
    EXPECT_NEAR(sum->by_yield, by_yield, tolerance(1e-14 * size));
    EXPECT_NEAR(sum->stiffness_normal, aa, tolerance(1e-14 * aa));
    EXPECT_NEAR(sum->yield_normal, ww, tolerance(1e-14 * ww));
  }
}

TEST(RisingIdeal, IsNotForWhatFallsOrIsNoNumber) {
  const std::vector<double> stress{0.0, 1.0, 2.0}, weight(3, 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(RisingIdeal::of(std::vector{0.0, 1.0, 1.0, 1.0}, stress, weight));
  EXPECT_FALSE(RisingIdeal::of(std::vector{0.0, 1.0, 0.9}, stress, weight));
  EXPECT_FALSE(RisingIdeal::of(std::vector{0.0, 1.0, 2.0, 1.9}, stress, weight));
  EXPECT_FALSE(RisingIdeal::of(std::vector{0.0, nan, 2.0}, stress, weight));
  EXPECT_FALSE(RisingIdeal::of(std::vector{0.0, 1.0, 2.0}, std::vector{0.0, nan, 0.0}, weight));
}

TEST(RisingIdeal, PermanentStrainIsThatOfTheDrivesEnd) {
  const auto closed =
      RisingIdeal::of(std::vector{0.0, 1e-3, 5e-3}, std::vector{0.0, 2e8}, std::vector{1.0, 1.0});
  const auto permanent = closed->permanent(200e9, 300e6);
  EXPECT_NEAR(permanent.strain, 3.5e-3, 1e-18);
  EXPECT_NEAR(permanent.by_stiffness, 300e6 / 4e22, 1e-30);
  EXPECT_NEAR(permanent.by_yield, -5e-12, 1e-27);
  EXPECT_EQ(closed->permanent(200e9, 2e9).strain, 0.0);
}

/// The misfit's own samples, which it follows one by one, against its sums.
TEST(RisingIdeal, GivesTheMisfitThatItsSamplesGive) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> strain, stress;
    for (double e = i % 3 == 0 ? -1e-5 : 0.0; e < 0.01; e += 4e-4 * unit(random)) {
      strain.push_back(e);
      stress.push_back(std::min(200e9 * e, 300e6) + 3e6 * unit(random));
    }
    Target target = target_of(strain, stress);
    target.test = i % 4 == 1 ? Deformation::Bending : Deformation::Tension;
    break_at(target, strain.back() + 2e-4, 0.008);
    FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
    if (i % 2 == 0) options.objective = Objective::LeastSquares;
    const ParameterSet set(target, options);
    Misfit misfit(target, options, set);
    for (int k = 0; k < 5; ++k) {
      const std::vector<double> at{200e9 * (0.5 + unit(random)), 300e6 * (0.5 + unit(random))};
      std::vector<double> gradient(2), normal(4);
      const double cost = misfit.search_squares(at, gradient, normal);
      const double off = misfit.break_residual();
      const double permanent = misfit.permanent_strain();
      const Misfit::Details d = Misfit(target, options, set).details(at);
      double sum = off * off;
      std::vector<double> by(2), squares(4);
      for (std::size_t s = 0; s < d.residual.size(); ++s) {
        sum += misfit.weights()[s] * d.residual[s] * d.residual[s];
        for (std::size_t a = 0; a < 2; ++a) {
          const double slope = d.jacobian[a * d.residual.size() + s];
          by[a] += misfit.weights()[s] * d.residual[s] * slope;
          for (std::size_t b = 0; b < 2; ++b) {
            squares[a * 2 + b] +=
                misfit.weights()[s] * slope * d.jacobian[b * d.residual.size() + s];
          }
        }
      }
      EXPECT_NEAR(cost, sum, tolerance(1e-12 * sum)) << i << ' ' << k;
      EXPECT_NEAR(permanent, d.permanent, tolerance(1e-15 * d.permanent));
      if (off != 0.0) continue;  // the break adds to the slopes
      for (std::size_t a = 0; a < 2; ++a) {
        const double scale = std::sqrt(sum * squares[a * 2 + a]);
        EXPECT_NEAR(gradient[a], by[a], tolerance(1e-12 * scale));
        for (std::size_t b = 0; b < 2; ++b) {
          EXPECT_NEAR(normal[a * 2 + b], squares[a * 2 + b],
                      tolerance(1e-12 * std::sqrt(squares[a * 3] * squares[b * 3])));
        }
      }
      // The permanent strain of the run sample by sample.
      std::vector<double> residual(strain.size());
      EXPECT_TRUE(misfit.residuals(at, residual));
      EXPECT_EQ(misfit.permanent_strain(), permanent);
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
