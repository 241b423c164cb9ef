#include "calibrate/problem/rising_ideal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

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

/// What a fit may be of: kinds of tests, factors of stiffness and yield stress, parameters that are
/// fixed or tied, and what is not in closed form.
struct Kind {
  const char* name;
  Deformation test = Deformation::Tension;
  Formulas formulas = Formulas::Mechanics;
  YieldCap cap = YieldCap::FirstYield;
  bool has_rate = false;
  bool is_fixed = false;
  bool is_tied = false;
};
constexpr Kind kKinds[] = {
    {.name = "tension"},
    {.name = "bending", .test = Deformation::Bending},
    {.name = "plastic bending", .test = Deformation::Bending, .cap = YieldCap::FullyPlastic},
    {.name = "reported bending", .test = Deformation::Bending, .formulas = Formulas::Report},
    {.name = "reported tension", .formulas = Formulas::Report},
    {.name = "torsion", .test = Deformation::Torsion},
    {.name = "rate", .has_rate = true},
    {.name = "fixed", .is_fixed = true},
    {.name = "tied", .is_tied = true},
};

class AnyMisfit : public ::testing::TestWithParam<Kind> {
 protected:
  FitOptions options() const {
    const Kind& kind = GetParam();
    FitOptions made =
        fit_of({kind.is_fixed ? fixed_parameter("youngs_modulus", 200e9)
                              : free_parameter("youngs_modulus"),
                kind.is_tied ? tied_parameter("yield_stress", "youngs_modulus", 1.5e-3)
                             : free_parameter("yield_stress"),
                free_parameter("break_strain")});
    made.setup.scene.formulas = kind.formulas;
    made.setup.scene.yield_cap = kind.cap;
    if (kind.has_rate)
      made.setup.scene.material.rate = {RateLaw::CowperSymonds, 100.0, 4.0, {}, {}};
    return made;
  }
  Target target(std::mt19937& random, bool negative) const {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> strain, stress;
    for (double e = negative ? -1e-5 : 0.0; e < 0.01; e += 4e-4 * unit(random)) {
      strain.push_back(e);
      stress.push_back(std::min(200e9 * e, 300e6) + 3e6 * unit(random));
    }
    Target made = target_of(strain, stress, GetParam().test);
    if (GetParam().has_rate) made.properties = {{"strain_rate", 50.0}};
    // Sometimes so large that the break counts in the search.
    break_at(made, strain.back() + 2e-4, unit(random) < 0.5 ? 0.008 : 0.5);
    return made;
  }
};

/// The misfit's own samples, which it follows one by one, against what a search is told.
TEST_P(AnyMisfit, IsWhatItsSamplesGive) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 40; ++i) {
    const Target curve = target(random, i % 3 == 0);
    FitOptions how = options();
    if (i % 2 == 0) how.objective = Objective::LeastSquares;
    if (i % 4 == 0) how.weights = {{0.0, 1.0}, {0.002, 0.0}, {0.006, 3.0}};
    const ParameterSet set(curve, how);
    Misfit misfit(curve, how, set);
    std::vector<double> at;
    for (const std::size_t k : set.active()) {
      at.push_back(set.all()[k].start * (0.5 + unit(random)));
    }
    const std::size_t n = at.size();
    std::vector<double> gradient(n), normal(n * n);
    const double cost = misfit.search_squares(at, gradient, normal);
    const double off = misfit.break_residual();
    const double permanent = misfit.permanent_strain();
    const Misfit::Details d = Misfit(curve, how, set).details(at);  // has not searched
    double sum = off * off;
    std::vector<double> squares(n * n);
    for (std::size_t s = 0; s < d.residual.size(); ++s) {
      const double weight = misfit.weights()[s];
      sum += weight * d.residual[s] * d.residual[s];
      for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = 0; b < n; ++b) {
          squares[a * n + b] += weight * d.jacobian[a * d.residual.size() + s] *
                                d.jacobian[b * d.residual.size() + s];
        }
      }
    }
    EXPECT_NEAR(cost, sum, tolerance(1e-12 * sum)) << i;
    EXPECT_NEAR(permanent, d.permanent, tolerance(2e-15 * d.permanent + 1e-18));
    for (std::size_t a = 0; a < n; ++a) {
      // Of the whole cost, the break's part included, by differences.
      std::vector<double> up = at, down = at;
      const double step = 1e-6 * at[a];
      up[a] += step;
      down[a] -= step;
      const double quotient =
          (misfit.search_cost(up, {}) - misfit.search_cost(down, {})) / (2.0 * step);
      EXPECT_NEAR(2.0 * gradient[a], quotient, tolerance(1e-4 * (cost / at[a]))) << i << ' ' << a;
      if (off != 0.0) continue;
      for (std::size_t b = 0; b < n; ++b) {
        const double scale = std::sqrt(squares[a * n + a] * squares[b * n + b]);
        EXPECT_NEAR(normal[a * n + b], squares[a * n + b], tolerance(1e-12 * scale));
      }
    }
    // Following it for its residuals leaves all else as it was, to the last bit.
    EXPECT_EQ(misfit.search_squares(at, gradient, normal), cost);
    std::vector<double> residual(d.residual.size());
    EXPECT_TRUE(misfit.residuals(at, residual));
    EXPECT_EQ(residual, d.residual);
    EXPECT_EQ(misfit.permanent_strain(), permanent);
  }
}

/// To the last bit: else what is above would hold of the followed samples alone.
/// Bit by bit: a fit is explained by the misfit of its last search.
TEST_P(AnyMisfit, AfterASearchIsAsOneThatHasNotSearched) {
  std::mt19937 random(11);
  for (int i = 0; i < 6; ++i) {
    const Target curve = target(random, false);
    const FitOptions how = options();
    const ParameterSet set(curve, how);
    Misfit searched(curve, how, set), fresh(curve, how, set);
    std::vector<double> at;
    for (const std::size_t k : set.active()) at.push_back(set.all()[k].start);
    std::vector<double> gradient(at.size()), again(at.size());
    searched.search_cost(at, gradient);
    searched.end_search();
    EXPECT_EQ(searched.cost(at, gradient), fresh.cost(at, again));
    EXPECT_EQ(gradient, again);
    const Misfit::Details d = searched.details(at), e = fresh.details(at);
    EXPECT_EQ(d.stress_cost, e.stress_cost);
    EXPECT_EQ(d.break_cost, e.break_cost);
    EXPECT_EQ(d.residual, e.residual);
    EXPECT_EQ(d.jacobian, e.jacobian);
    EXPECT_EQ(d.permanent, e.permanent);
    EXPECT_EQ(d.permanent_gradient, e.permanent_gradient);
  }
}

TEST(RisingIdeal, IsWhatASearchIsTold) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const Curves c(random);
    const std::vector<double> strain(c.strain.begin(), c.strain.end() - 1);
    const Target target = target_of(strain, c.stress);  // has not broken
    const FitOptions options =
        fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
    const ParameterSet set(target, options);
    Misfit misfit(target, options, set);
    const auto sum = RisingIdeal::of(strain, c.stress, misfit.weights());
    if (!sum) continue;  // a path of no length has no weights
    EXPECT_EQ(misfit.search_cost(std::vector{190e9, 280e6}, {}), sum->sum(190e9, 280e6)->squares);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, AnyMisfit, ::testing::ValuesIn(kKinds), [](const auto& test) {
  std::string name;
  for (const char c : std::string(test.param.name)) name += c == ' ' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace plastica::calibrate
