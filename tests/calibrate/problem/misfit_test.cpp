#include "calibrate/problem/misfit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

/// A misfit with all that it looks at.
struct Case {
  Case(Target t, FitOptions o)
      : target(std::move(t)), options(std::move(o)), set(target, options) {}
  double cost(const std::vector<double>& active) {
    return Misfit(target, options, set).cost(active, {});
  }
  std::vector<double> gradient(const std::vector<double>& active) {
    std::vector<double> by(active.size());
    Misfit(target, options, set).cost(active, by);
    return by;
  }

  Target target;
  FitOptions options;
  ParameterSet set;
};

/// E = 200 GPa, Y = 300 MPa against four samples at unequal distances: r = 0, 10, -20, 40 MPa.
Target four_samples() {
  Target target = target_of({0.0, 0.001, 0.002, 0.006}, {0.0, 190e6, 320e6, 260e6});
  break_at(target, 0.008, 0.005);  // broke at 0.007
  return target;
}

TEST(Misfit, IsTheIntegralOfTheTrapeziaOverTheStrainPath) {
  Case c(four_samples(),
         fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  // (1 (0 + 100) + 1 (100 + 400) + 4 (400 + 1600))/2 / 6 MPa^2.
  const double expected = (0.5 * 100.0 + 0.5 * 500.0 + 2.0 * 2000.0) / 6.0 * 1e12;
  EXPECT_NEAR(c.cost({200e9, 300e6}), expected, tolerance(1e-12 * expected));
}

TEST(Misfit, RunsTheModelOnceAtAPointAndOnceMoreForItsSlopes) {
  Case c(four_samples(),
         fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  Misfit misfit(c.target, c.options, c.set);
  const std::vector<double> here{200e9, 300e6};
  const std::vector<double> there{200e9, 301e6};
  std::vector<double> by(2);
  const auto runs = [&](const std::vector<double>& at, std::span<double> gradient) {
    misfit.cost(at, gradient);
    return misfit.was_run();
  };
  EXPECT_TRUE(runs(here, {}));
  EXPECT_FALSE(runs(here, {}));
  EXPECT_TRUE(runs(here, by));
  EXPECT_FALSE(runs(here, by));
  EXPECT_FALSE(runs(here, {}));
  EXPECT_EQ(misfit.cost(here, by), c.cost(here));
  EXPECT_EQ(by, c.gradient(here));
  EXPECT_TRUE(runs(there, {}));
  EXPECT_EQ(misfit.cost(there, by), c.cost(there));
  EXPECT_EQ(by, c.gradient(there));
}

TEST(Misfit, IsTheMeanSquareInLeastSquares) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  const double expected = (100.0 + 400.0 + 1600.0) / 4.0 * 1e12;
  EXPECT_NEAR(Case(four_samples(), options).cost({200e9, 300e6}), expected,
              tolerance(1e-12 * expected));
  options.noise = 3e6;  // cancels
  EXPECT_NEAR(Case(four_samples(), options).cost({200e9, 300e6}), expected,
              tolerance(1e-12 * expected));
}

TEST(Misfit, AddsTheBreakTermWithItsWeight) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                               free_parameter("break_strain")});
  // The model's permanent strain at 0.007 is 0.007 - 300/200e3 = 0.0055; S = 320 MPa, P = 0.005.
  const double stress = (0.5 * 100.0 + 0.5 * 500.0 + 2.0 * 2000.0) / 6.0 * 1e12;
  const double term = 320e6 * 320e6 * std::pow((0.0055 - 0.004) / 0.005, 2);
  for (const double weight : {1.0, 0.25}) {
    options.break_weight = weight;
    const double expected = stress + weight * term;
    EXPECT_NEAR(Case(four_samples(), options).cost({200e9, 300e6, 0.004}), expected,
                tolerance(1e-12 * expected));
  }
}

TEST(Misfit, ReportsThePartsOfItsCost) {
  Case c(four_samples(), fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                                 free_parameter("break_strain")}));
  Misfit misfit(c.target, c.options, c.set);
  const std::vector<double> at{200e9, 300e6, 0.004};
  const Misfit::Details d = misfit.details(at);
  EXPECT_NEAR(d.stress_cost + d.break_cost, misfit.cost(at, {}), tolerance(1e-12 * d.stress_cost));
  const std::vector<double> residual{0.0, 10e6, -20e6, 40e6};
  const std::vector<double> weight{0.0005, 0.001, 0.0025, 0.002};
  const std::vector<double> by_young{0.0, 0.001, 0.0, 0.0};
  const std::vector<double> by_yield{0.0, 0.0, 1.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(d.residual[i], residual[i], tolerance(1e-3));
    EXPECT_NEAR(d.weight[i], weight[i], tolerance(1e-15));
    EXPECT_NEAR(d.jacobian[i], by_young[i], tolerance(1e-15));
    EXPECT_NEAR(d.jacobian[d.residual.size() + i], by_yield[i], tolerance(1e-15));
    EXPECT_EQ(d.jacobian[2 * d.residual.size() + i], 0.0);
  }
  EXPECT_NEAR(d.permanent, 0.0055, tolerance(1e-15));
  // p = strain - Y/E.
  EXPECT_NEAR(d.permanent_gradient[0], 300e6 / (200e9 * 200e9), tolerance(1e-24));
  EXPECT_NEAR(d.permanent_gradient[1], -1.0 / 200e9, tolerance(1e-24));
  EXPECT_EQ(d.permanent_gradient[2], 0.0);
}

TEST(Misfit, HasTheCurvatureOfGaussAndNewton) {
  Case c(four_samples(), fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                                 free_parameter("break_strain")}));
  Misfit misfit(c.target, c.options, c.set);
  const std::vector<double> curvature = misfit.curvature(std::vector<double>{200e9, 300e6, 0.004});
  // 2 sum w (dr/da)^2 / sum w: E moves the second sample alone, Y the last two.
  EXPECT_NEAR(curvature[0], 2.0 * 0.001 * 1e-6 / 0.006, tolerance(1e-18));
  EXPECT_NEAR(curvature[1], 2.0 * 0.0045 / 0.006, tolerance(1e-12));
  EXPECT_NEAR(curvature[2] * 0.005 * 0.005, 2.0 * 320e6 * 320e6, tolerance(1e5));
}

TEST(Misfit, BreakTermVanishesAtTheRightBreakStrainAndHasNoOtherGradient) {
  Case with(four_samples(),
            fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                    free_parameter("break_strain")}));
  Case without(four_samples(),
               fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  const double permanent = 0.007 - 310e6 / 195e9;
  EXPECT_NEAR(with.cost({195e9, 310e6, permanent}), without.cost({195e9, 310e6}), tolerance(1.0));
  const auto a = with.gradient({195e9, 310e6, permanent});
  const auto b = without.gradient({195e9, 310e6});
  EXPECT_NEAR(a[0], b[0], tolerance(1e-9 * std::fabs(b[0])));
  EXPECT_NEAR(a[1], b[1], tolerance(1e-9 * std::fabs(b[1])));
  // d f/d b = -2 S^2/P^2 (p - b), all of it rounding here.
  EXPECT_LT(std::fabs(a[2]), 1e-9 * 320e6 * 320e6 / 0.005);
}

TEST(Misfit, DoesNotDependOnHowDenselyACurveIsSampled) {
  // A measured curve of straight lines whose corners and the model's kink are samples: residuals
  // are straight in between, and the path integral of their square is what sampling tends to.
  const auto measured = [](double e) { return e < 0.002 ? 180e9 * e : 360e6 + 1e9 * (e - 0.002); };
  const auto cost = [&](std::size_t n) {
    std::vector<double> strain = path({0.0015, 0.002, 0.02}, n);
    std::vector<double> stress;
    for (const double e : strain) stress.push_back(measured(e));
    Case c(target_of(strain, stress),
           fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
    return c.cost({200e9, 300e6});
  };
  // The trapezia of r^2 between samples differ from its integral by O(1/n^2).
  const double exact = (4.0 * cost(2048) - cost(1024)) / 3.0;
  EXPECT_NEAR((4.0 * cost(64) - cost(32)) / 3.0, exact, tolerance(1e-9 * exact));
  EXPECT_NEAR(cost(64), exact, tolerance(1e-3 * exact));
  // Ten more samples on one stretch than on the others change nothing beyond that, while the mean
  // square of the samples moves by tens of percent.
  std::vector<double> strain = path({0.0015, 0.002, 0.02}, 64);
  const std::vector<double> dense = path({0.0015}, 640);
  strain.erase(strain.begin(), strain.begin() + 65);
  strain.insert(strain.begin(), dense.begin(), dense.end());
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(measured(e));
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  EXPECT_NEAR(Case(target_of(strain, stress), options).cost({200e9, 300e6}), exact,
              tolerance(1e-3 * exact));
  options.objective = Objective::LeastSquares;
  EXPECT_LT(Case(target_of(strain, stress), options).cost({200e9, 300e6}), 0.7 * exact);
}

TEST(Misfit, RepeatedSamplesChangeNothingAlongTheStrainPath) {
  const FitOptions options =
      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  Case once(target_of({0.0, 0.001, 0.002, 0.006}, {0.0, 190e6, 320e6, 260e6}), options);
  Case twice(
      target_of({0.0, 0.001, 0.001, 0.002, 0.002, 0.006}, {0.0, 190e6, 190e6, 320e6, 320e6, 260e6}),
      options);
  const double cost = once.cost({200e9, 300e6});
  EXPECT_NEAR(twice.cost({200e9, 300e6}), cost, tolerance(1e-14 * cost));
}

TEST(Misfit, FollowsACyclicPath) {
  // 0 -> 0.003 -> -0.003 with E = 200 GPa and Y = 300 MPa: the way back yields at -0.0 strain.
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  Case c(target_of({0.0, 0.003, 0.0015, 0.0, -0.003}, {0.0, 290e6, 0.0, -300e6, -310e6}), options);
  // Model: 0, 300, 0, -300, -300 MPa: r = 0, 10, 0, 0, 10 MPa over 3, 1.5, 1.5, 3 mm/m.
  const double expected = 0.5 * (3.0 * 100.0 + 1.5 * 100.0 + 3.0 * 100.0) / 9.0 * 1e12;
  EXPECT_NEAR(c.cost({200e9, 300e6}), expected, tolerance(1e-10 * expected));
}

TEST(Misfit, IsInfiniteWhereTheModelCannotBeRun) {
  FitOptions options =
      fit_of({free_parameter("youngs_modulus"), free_parameter("tangent_modulus")});
  options.setup.scene.material.hardening.law = HardeningLaw::Linear;
  Case c(four_samples(), options);
  EXPECT_TRUE(std::isinf(c.cost({200e9, 200e9})));  // not below E
  EXPECT_TRUE(std::isinf(c.cost({-1.0, 0.0})));
  EXPECT_TRUE(std::isfinite(c.cost({200e9, 199e9})));
}

TEST(Misfit, NamesAParameterThatNoScenePermits) {
  FitOptions options = fit_of({free_parameter("yield_stress")});
  options.setup.scene.beam.segments = 0;
  EXPECT_EQ(message_of([&] { Case(four_samples(), options).cost({300e6}); }),
            "beam.segments = 0: must be from 1 to 1e+07");
}

/// A law, a test and a break measure: gradients must be right in all of them.
struct Derivative {
  std::string name;
  HardeningLaw law;
  Deformation test;
  BreakMeasure measure;
  bool report = false;
};

class EveryLaw : public ::testing::TestWithParam<Derivative> {};

TEST_P(EveryLaw, GradientIsTheDifferenceQuotientOverDecades) {
  const Derivative& d = GetParam();
  const bool torsion = d.test == Deformation::Torsion;
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                               free_parameter("break_strain")});
  options.setup.scene.break_measure = d.measure;
  if (d.report) options.setup.scene.formulas = Formulas::Report;
  Hardening& hardening = options.setup.scene.material.hardening;
  hardening.law = d.law;
  std::vector<double> at{180e9, 280e6, 0.031};
  if (d.law == HardeningLaw::Linear) {
    options.parameters.push_back(free_parameter("tangent_modulus"));
    options.parameters.push_back(free_parameter("kinematic_fraction"));
    at.insert(at.end(), {3e9, 0.4});
  }
  if (d.law == HardeningLaw::VoceChaboche) {
    for (const char* name : {"saturation_stress", "saturation_rate", "backstress_modulus_1",
                             "backstress_rate_1", "backstress_modulus_2"}) {
      options.parameters.push_back(free_parameter(name));
    }
    options.parameters.push_back(tied_parameter("backstress_modulus_3", "yield_stress", 7.0));
    options.parameters.push_back(fixed_parameter("backstress_rate_3", 2.0));
    at.insert(at.end(), {60e6, 11.0, 20e9, 250.0, 2e9});
  }
  if (d.law == HardeningLaw::Multilinear) {
    hardening.plastic_strain = {0.002, 0.02};
    hardening.flow_stress = {360e6, 370e6};
    for (const char* name : {"flow_stress_1", "flow_stress_2", "kinematic_fraction"}) {
      options.parameters.push_back(free_parameter(name));
    }
    at.insert(at.end(), {301e6, 330e6, 0.4});
  }
  if (torsion) {
    options.parameters.push_back(tied_parameter("shear_yield_stress", "yield_stress", 0.55));
    options.parameters.push_back(free_parameter("shear_modulus"));
    at.push_back(70e9);
  }
  const std::vector<double> strain = path({0.011, -0.013, 0.004, -0.002, 0.017}, 23);
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(230e6 * std::tanh(500.0 * e) + 1e9 * e);
  Target target = target_of(strain, stress, d.test);
  target.loading = Loading::Cyclic;
  break_at(target, 0.018, 0.014);

  Case c(target, options);
  const std::vector<double> gradient = c.gradient(at);
  const double cost = c.cost(at);
  for (std::size_t i = 0; i < at.size(); ++i) {
    double best = 1e300;
    for (double h = 1e-3; h > 1e-9; h /= 10.0) {
      std::vector<double> up = at;
      std::vector<double> down = at;
      up[i] += h * at[i];
      down[i] -= h * at[i];
      const double quotient = (c.cost(up) - c.cost(down)) / (up[i] - down[i]);
      best = std::min(best, std::fabs(quotient - gradient[i]));
    }
    EXPECT_LT(best, tolerance(2e-7 * (std::fabs(gradient[i]) + cost / at[i])))
        << c.options.parameters[c.set.active()[i]].name() << " " << gradient[i];
    // What is not identifiable has no slope, and all else has one.
    const std::string name = c.options.parameters[c.set.active()[i]].name();
    const bool unidentifiable =
        torsion && name == "youngs_modulus" && d.law != HardeningLaw::Linear;
    EXPECT_EQ(gradient[i] == 0.0, unidentifiable) << name;
  }
}

const Derivative kDerivatives[] = {
    {"IdealTensionNet", HardeningLaw::Ideal, Deformation::Tension, BreakMeasure::Net},
    {"IdealTensionAccumulated", HardeningLaw::Ideal, Deformation::Tension,
     BreakMeasure::Accumulated},
    {"IdealBendingNet", HardeningLaw::Ideal, Deformation::Bending, BreakMeasure::Net},
    {"IdealBendingReport", HardeningLaw::Ideal, Deformation::Bending, BreakMeasure::Net, true},
    {"IdealTorsionNet", HardeningLaw::Ideal, Deformation::Torsion, BreakMeasure::Net},
    {"IdealTorsionReport", HardeningLaw::Ideal, Deformation::Torsion, BreakMeasure::Net, true},
    {"LinearTensionNet", HardeningLaw::Linear, Deformation::Tension, BreakMeasure::Net},
    {"LinearBendingAccumulated", HardeningLaw::Linear, Deformation::Bending,
     BreakMeasure::Accumulated},
    {"LinearTorsionAccumulated", HardeningLaw::Linear, Deformation::Torsion,
     BreakMeasure::Accumulated},
    {"VoceTensionAccumulated", HardeningLaw::VoceChaboche, Deformation::Tension,
     BreakMeasure::Accumulated},
    {"VoceTensionNet", HardeningLaw::VoceChaboche, Deformation::Tension, BreakMeasure::Net},
    {"VoceBendingNet", HardeningLaw::VoceChaboche, Deformation::Bending, BreakMeasure::Net},
    {"TableTensionNet", HardeningLaw::Multilinear, Deformation::Tension, BreakMeasure::Net},
    {"TableBendingAccumulated", HardeningLaw::Multilinear, Deformation::Bending,
     BreakMeasure::Accumulated},
    {"TableTorsionAccumulated", HardeningLaw::Multilinear, Deformation::Torsion,
     BreakMeasure::Accumulated},
    {"VoceTorsionNet", HardeningLaw::VoceChaboche, Deformation::Torsion, BreakMeasure::Net},
};

INSTANTIATE_TEST_SUITE_P(Names, EveryLaw, ::testing::ValuesIn(kDerivatives),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace plastica::calibrate
