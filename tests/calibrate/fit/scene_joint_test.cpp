#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "calibrate/fit/scene_fit.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"

/// Several targets in one fit.
namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::free_parameter;
using testing::stiffness_and_yield;
using testing::Truth;

/// The bar of `bend_test`, its end twisted by half a turn in place of being pushed.
plastica::Setup twist_test(int segments) {
  plastica::Setup setup = bend_test(segments);
  Scene& scene = setup.scene;
  scene.yield_model = YieldModel::PerAxis;
  scene.yield_cap = YieldCap::FullyPlastic;
  scene.supports[1] = Support{.at = Place::end(), .kind = SupportKind::Pin};
  scene.supports[1].rotation = {0.0, 0.0, 1.0};
  scene.supports[1].hold = HeldFreedoms{true, true, false, false, false, true};
  scene.probes = {{.name = "torque",
                   .quantity = ProbeQuantity::ReactionMoment,
                   .at = Place::end(),
                   .component = Component::Z}};
  return setup;
}

void make_curve(WeightedTarget& weighted, const Truth& truth, double noise, unsigned seed) {
  weighted.target.ordinate.assign(weighted.target.abscissa.size(), 0.0);
  const SceneModel model(
      weighted.setup, weighted.target,
      {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")});
  const std::vector<double> values{truth.youngs_modulus, truth.yield_stress};
  const SceneCurve curve = model.run(values, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0.0, noise);
  for (std::size_t i = 0; i < curve.ordinate.size(); ++i) {
    weighted.target.ordinate[i] = curve.ordinate[i] + error(random);
  }
}

WeightedTarget bent(int segments, double noise, unsigned seed) {
  WeightedTarget weighted;
  weighted.setup = bend_test(segments);
  weighted.target.name = "bent";
  weighted.target.kind = Abscissa::Support;
  weighted.target.driven = 1;
  weighted.target.ordinate_probe = "force";
  weighted.target.ordinate_factor = -1.0;
  for (int i = 1; i <= 30; ++i) weighted.target.abscissa.push_back(2e-3 * i);
  for (int i = 1; i <= 10; ++i) weighted.target.abscissa.push_back(0.06 - 4e-3 * i);
  make_curve(weighted, {}, noise, seed);
  return weighted;
}

WeightedTarget twisted(int segments, double noise, unsigned seed) {
  WeightedTarget weighted;
  weighted.setup = twist_test(segments);
  weighted.target.name = "twisted";
  weighted.target.kind = Abscissa::Support;
  weighted.target.driven = 1;
  weighted.target.ordinate_probe = "torque";
  for (int i = 1; i <= 30; ++i) weighted.target.abscissa.push_back(0.02 * i);
  make_curve(weighted, {}, noise, seed);
  return weighted;
}

TEST(SceneJointFit, IsTighterThanEachTargetAlone) {
  const std::vector<WeightedTarget> targets{bent(8, 5.0, 1), twisted(8, 3.0, 2)};
  const SceneFitOptions options{
      .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
  const SceneFitResult both = fit(targets, options);
  ASSERT_EQ(both.status, FitStatus::Fitted) << both.reason;
  EXPECT_EQ(both.targets[0].level, Level::Planar);
  EXPECT_EQ(both.targets[1].level, Level::Twist);
  for (std::size_t p = 0; p < 2; ++p) {
    const SceneFitResult alone = fit_scene(targets[p].setup, targets[p].target, options);
    for (const char* name : {"youngs_modulus", "yield_stress"}) {
      EXPECT_LT(both.parameter(name).standard_error, alone.parameter(name).standard_error)
          << name << " of " << p;
    }
  }
  // Each target's noise is found: 5 N and 3 N m, from 40 and 30 samples.
  EXPECT_NEAR(both.targets[0].noise, 5.0, 1.5);
  EXPECT_NEAR(both.targets[1].noise, 3.0, 1.0);
  EXPECT_NEAR(both.parameter("youngs_modulus").value, Truth{}.youngs_modulus,
              4.0 * both.parameter("youngs_modulus").standard_error);
  EXPECT_NEAR(both.parameter("yield_stress").value, Truth{}.yield_stress,
              4.0 * both.parameter("yield_stress").standard_error);
  EXPECT_EQ(both.parameter("yield_stress").verdict(), Verdict::Identified);
}

/// Whoever states the noise that a fit found gets the same values, though the targets disagree.
TEST(SceneJointFit, HasTheValuesOfTheWeightsThatItReports) {
  std::vector<WeightedTarget> targets{bent(8, 5.0, 1), twisted(8, 3.0, 2)};
  make_curve(targets[1], {.youngs_modulus = 1.05 * Truth{}.youngs_modulus}, 3.0, 2);
  const SceneFitOptions options{
      .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
  const SceneFitResult found = fit(targets, options);
  for (std::size_t t = 0; t < 2; ++t) targets[t].target.noise = found.targets[t].noise;
  const SceneFitResult stated = fit(targets, options);
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    EXPECT_NEAR(found.parameter(name).value / stated.parameter(name).value, 1.0, 1e-7) << name;
  }
}

TEST(SceneFitMisfit, AddsErrorsWhereResidualsLieInRuns) {
  SceneFitOptions options{.parameters = stiffness_and_yield()};
  options.segments_error = false;
  WeightedTarget weighted = bent(8, 5.0, 1);
  const SceneFitResult noisy = fit_scene(weighted.setup, weighted.target, options);
  for (const FittedParameter& p : noisy.parameters) EXPECT_LT(p.misfit_error, p.noise_error);
  // A bar that hardens twice as much as the scene says.
  const double hardening = weighted.setup.scene.material.hardening.tangent_modulus;
  weighted.setup.scene.material.hardening.tangent_modulus = 2.0 * hardening;
  make_curve(weighted, {}, 5.0, 1);
  weighted.setup.scene.material.hardening.tangent_modulus = hardening;
  const SceneFitResult wrong = fit_scene(weighted.setup, weighted.target, options);
  EXPECT_LT(wrong.targets[0].runs_test_p, 1e-3);
  for (const FittedParameter& p : wrong.parameters) EXPECT_GT(p.misfit_error, p.noise_error);
}

TEST(SceneJointFit, HasTheSameBitsOnEveryNumberOfThreads) {
  const std::vector<WeightedTarget> targets{bent(6, 5.0, 3), twisted(6, 3.0, 4)};
  SceneFitOptions options{.parameters = stiffness_and_yield(), .starts = 1};
  options.starts = 3;
  const SceneFitResult one = fit(targets, options);
  options.threads = 3;
  const SceneFitResult three = fit(targets, options);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.parameters[i].value, three.parameters[i].value);
    EXPECT_EQ(one.parameters[i].standard_error, three.parameters[i].standard_error);
    EXPECT_EQ(one.targets[i].fitted, three.targets[i].fitted);
    EXPECT_EQ(one.segments.value().parameters[i].error, three.segments.value().parameters[i].error);
  }
  ASSERT_EQ(three.starts.size(), 3U);
  EXPECT_EQ(one.runs, three.runs);
}

TEST(SceneJointFit, JoinsACouponWithABeam) {
  WeightedTarget coupon;
  coupon.setup.scene.material = bend_test(8).scene.material;
  coupon.setup.scene.drive.strain = {0.001};
  coupon.target.name = "coupon";
  coupon.target.kind = Abscissa::Strain;
  coupon.target.ordinate_probe = "stress";
  for (int i = 1; i <= 20; ++i) coupon.target.abscissa.push_back(2e-4 * i);
  make_curve(coupon, {}, 1e6, 5);
  const std::vector<WeightedTarget> targets{bent(8, 5.0, 6), coupon};
  const SceneFitResult one = fit(targets, {.parameters = stiffness_and_yield(), .starts = 1});
  ASSERT_EQ(one.status, FitStatus::Fitted) << one.reason;
  EXPECT_EQ(one.targets[1].level, Level::Coupon);
  EXPECT_NEAR(one.targets[1].noise, 1e6, 0.5e6);
  EXPECT_NEAR(one.parameter("youngs_modulus").value / Truth{}.youngs_modulus, 1.0, 0.01);
}

TEST(SceneJointFit, SaysThatTargetsDisagreeOnTheBreak) {
  std::vector<WeightedTarget> targets{bent(6, 0.5, 1), bent(6, 0.5, 2)};
  for (WeightedTarget& weighted : targets) {
    weighted.target.abscissa.resize(30);
    weighted.target.ordinate.resize(30);
  }
  // The second bar was pushed on.
  for (int i = 31; i <= 35; ++i) targets[1].target.abscissa.push_back(2e-3 * i);
  make_curve(targets[1], {}, 0.5, 2);
  targets[0].target.broke = SceneBreak{0.061, 0.001};
  targets[1].target.broke = SceneBreak{0.071, 0.001};
  const SceneFitOptions options{.parameters = testing::all_three(), .starts = 1};
  const auto disagrees = [](const SceneFitResult& fit) {
    return std::any_of(fit.warnings.begin(), fit.warnings.end(), [](const std::string& line) {
      return line.find("the targets disagree") != std::string::npos;
    });
  };
  const SceneFitResult apart = fit(targets, options);
  EXPECT_TRUE(disagrees(apart));
  EXPECT_LT(apart.targets[0].break_strain, apart.parameter("break_strain").value);
  EXPECT_GT(apart.targets[1].break_strain, apart.parameter("break_strain").value);
  // Of three the error is how they scatter, with two degrees of freedom.
  targets.push_back(targets[1]);
  targets[2].target.broke = SceneBreak{0.066, 0.001};
  make_curve(targets[2], {}, 0.5, 3);
  const SceneFitResult three = fit(targets, options);
  double mean = 0.0, squares = 0.0;
  for (const TargetFit& one : three.targets) mean += one.break_strain / 3.0;
  for (const TargetFit& one : three.targets) squares += std::pow(one.break_strain - mean, 2) / 6.0;
  EXPECT_NEAR(three.parameter("break_strain").misfit_error / std::sqrt(squares), 1.0, 0.3);
  EXPECT_LE(three.parameter("break_strain").degrees_of_freedom, 2.0);
  targets.pop_back();
  targets[1] = targets[0];
  EXPECT_FALSE(disagrees(fit(targets, options)));
}

bool bore_more(const SceneFitResult& fit, const std::string& how) {
  return std::ranges::any_of(fit.warnings, [&](const std::string& line) {
    return line.find("the specimen bore") != std::string::npos &&
           line.find(how) != std::string::npos;
  });
}

// One bar broke at 60 mm; another was pushed to 70 mm and bore it, or to 50 mm.
TEST(SceneJointFit, SaysThatASpecimenBoreMoreThanTheFittedBreakLimit) {
  std::vector<WeightedTarget> targets{bent(6, 0.5, 1), bent(6, 0.5, 2)};
  for (WeightedTarget& weighted : targets) {
    weighted.target.abscissa.resize(30);
    weighted.target.ordinate.resize(30);
  }
  targets[0].target.broke = SceneBreak{0.0601, 1e-4};
  targets[1].target.name = "pushed";
  for (int i = 31; i <= 35; ++i) targets[1].target.abscissa.push_back(2e-3 * i);
  make_curve(targets[1], {}, 0.5, 2);
  const SceneFitOptions options{
      .parameters = testing::all_three(), .starts = 1, .segments_error = false};
  EXPECT_TRUE(bore_more(fit(targets, options), "did not break at all, more than break_strain"));
  // Back from 70 mm it bore that too, whatever it has at the end.
  for (int i = 1; i <= 5; ++i) targets[1].target.abscissa.push_back(0.07 - 2e-3 * i);
  make_curve(targets[1], {}, 0.5, 2);
  EXPECT_TRUE(bore_more(fit(targets, options), "pushed: "));
  targets[1].target.abscissa.resize(25);
  make_curve(targets[1], {}, 0.5, 2);
  EXPECT_FALSE(bore_more(fit(targets, options), ""));
}

TEST(SceneJointFit, SaysThatASpecimenBoreMoreThanAHeldBreakLimit) {
  WeightedTarget weighted = bent(6, 0.5, 1);
  SceneFitOptions options{
      .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
  EXPECT_FALSE(bore_more(fit_scene(weighted.setup, weighted.target, options), ""));
  weighted.setup.scene.material.break_strain = 0.002;
  EXPECT_TRUE(bore_more(fit_scene(weighted.setup, weighted.target, options),
                        "break_strain allows, which is held at 0.2 %"));
  weighted.setup.scene.material.break_strain = 0.5;
  EXPECT_FALSE(bore_more(fit_scene(weighted.setup, weighted.target, options), ""));
  Parameter held;
  held.field = &find_field("break_strain");
  held.role = ParameterRole::Fixed;
  held.value = 0.003;
  options.parameters.push_back(held);
  EXPECT_TRUE(bore_more(fit_scene(weighted.setup, weighted.target, options), "held at 0.3 %"));
}

/// The bar broke at the end of its curve, at some 2 %.
WeightedTarget broken_bent(int segments) {
  WeightedTarget weighted = bent(segments, 0.5, 1);
  weighted.target.broke = SceneBreak{weighted.target.abscissa.back(), 0.0};
  return weighted;
}

TEST(SceneJointFit, SaysThatASpecimenBrokeBeforeALimitThatItsBreakDoesNotSet) {
  const WeightedTarget weighted = broken_bent(6);
  const auto broke_before = [&](ParameterRole role, double lower, double upper) {
    SceneFitOptions options{
        .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
    Parameter limit = testing::free_parameter("break_strain", lower, upper);
    limit.role = role;
    limit.value = upper;
    options.parameters.push_back(limit);
    const SceneFitResult one = fit_scene(weighted.setup, weighted.target, options);
    return std::ranges::any_of(one.warnings, [](const std::string& line) {
      return line.find("the specimen broke at a permanent strain of") != std::string::npos &&
             line.find("the fitted beam is intact where it broke") != std::string::npos;
    });
  };
  EXPECT_TRUE(broke_before(ParameterRole::Fixed, 1e-4, 0.2));
  EXPECT_FALSE(broke_before(ParameterRole::Free, 1e-4, 1.0));
  EXPECT_TRUE(broke_before(ParameterRole::Free, 0.1, 1.0)) << "at its lower bound";
}

TEST(SceneJointFit, SaysThatASpecimenBoreMoreThanALimitAtItsBound) {
  const WeightedTarget weighted = broken_bent(6);
  SceneFitOptions options{
      .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
  options.parameters.push_back(testing::free_parameter("break_strain", 1e-3, 5e-3));
  EXPECT_TRUE(bore_more(fit_scene(weighted.setup, weighted.target, options),
                        "went on, more than break_strain allows, which is fitted as 0.5 %"));
}

TEST(SceneJointFit, SaysThatSpecimensDiffer) {
  const auto differ = [](const std::vector<WeightedTarget>& targets) {
    const SceneFitResult one =
        fit(targets, {.parameters = stiffness_and_yield(), .starts = 1, .segments_error = false});
    return std::ranges::any_of(one.warnings, [](const std::string& line) {
      return line.find("differ by more than their noise does") != std::string::npos;
    });
  };
  std::vector<WeightedTarget> targets{bent(6, 1.0, 11), bent(6, 1.0, 12), bent(6, 1.0, 13)};
  EXPECT_FALSE(differ(targets));
  make_curve(targets[0], {205e9, 370e6}, 1.0, 11);
  make_curve(targets[2], {205e9, 400e6}, 1.0, 13);
  EXPECT_TRUE(differ(targets));
}

TEST(SceneJointFit, ReachesRegionsThatHaveTheScenesMaterial) {
  // The bar in two halves of one section is the bar.
  WeightedTarget weighted = bent(6, 1.0, 3);
  const SceneFitOptions options{.parameters = stiffness_and_yield(), .starts = 1};
  const SceneFitResult whole = fit_scene(weighted.setup, weighted.target, options);
  Region half;
  half.from = {0.5, {}};
  half.to = Place::end();
  half.section = weighted.setup.scene.section;
  half.material = weighted.setup.scene.material;
  half.own = {};
  weighted.setup.scene.regions.push_back(half);
  const SceneFitResult halves = fit_scene(weighted.setup, weighted.target, options);
  for (const char* name : {"youngs_modulus", "yield_stress"}) {
    EXPECT_NEAR(halves.parameter(name).value / whole.parameter(name).value, 1.0, 1e-6) << name;
  }
}

TEST(SceneJointFit, RunsNoPointTwice) {
  // Differences at the solution serve the errors and the break strain's slope.
  WeightedTarget weighted = bent(6, 1.0, 4);
  weighted.target.abscissa.resize(30);
  weighted.target.ordinate.resize(30);
  const SceneFitResult two = fit_scene(weighted.setup, weighted.target,
                                       {.parameters = stiffness_and_yield(), .starts = 1});
  weighted.target.broke = SceneBreak{0.061, 0.001};
  const SceneFitResult three =
      fit_scene(weighted.setup, weighted.target, {.parameters = testing::all_three(), .starts = 1});
  EXPECT_EQ(three.runs, two.runs);
}

// The bar has 205 GPa, which its curve says within 0.3 % or so.
TEST(SceneJointFit, SaysThatCurvesContradictAPrior) {
  const WeightedTarget weighted = bent(6, 5.0, 1);
  SceneFitOptions options{
      .parameters = stiffness_and_yield(), .starts = 1, .segments_error = false};
  const SceneFitResult alone = fit_scene(weighted.setup, weighted.target, options);
  const auto contradicted = [&](double mean, double deviation) {
    options.parameters[0].prior = Prior{mean, deviation};
    const SceneFitResult fit = fit_scene(weighted.setup, weighted.target, options);
    const auto warning = std::ranges::find_if(fit.warnings, [](const std::string& line) {
      return line.find("the curves contradict the prior of youngs_modulus") != std::string::npos;
    });
    return warning == fit.warnings.end() ? std::string() : *warning;
  };
  EXPECT_EQ(contradicted(205e9, 1e9), "");
  EXPECT_EQ(contradicted(195e9, 10e9), "");
  EXPECT_NE(contradicted(160e9, 5e9), "");
  EXPECT_NE(contradicted(160e9, 0.1e9), "");  // where the prior has its way
  EXPECT_NE(contradicted(250e9, 5e9), "");
  // Two and four standard errors of both away from what the curves say by themselves.
  const FittedParameter& E = alone.parameter("youngs_modulus");
  const double both = std::hypot(E.noise_error, 1e9);
  EXPECT_EQ(contradicted(E.value - 2.0 * both, 1e9), "");
  EXPECT_NE(contradicted(E.value - 4.0 * both, 1e9), "");
}

TEST(SceneJointFit, LetsPriorsAndTiesSayWhatCurvesDoNot) {
  // A bar that does not yield says nothing of its yield stress; a prior does.
  WeightedTarget weighted = bent(6, 0.5, 7);
  weighted.target.abscissa.assign({1e-4, 2e-4, 4e-4, 6e-4, 1e-3, 2e-3});
  make_curve(weighted, {}, 0.05, 8);
  SceneFitOptions options{.parameters = stiffness_and_yield(), .starts = 1};
  const SceneFitResult unidentified = fit_scene(weighted.setup, weighted.target, options);
  EXPECT_EQ(unidentified.parameter("yield_stress").verdict(), Verdict::NotIdentified);
  options.parameters[1].prior = Prior{400e6, 20e6};
  weighted.target.noise = 0.05;
  const SceneFitResult known = fit_scene(weighted.setup, weighted.target, options);
  EXPECT_NEAR(known.parameter("yield_stress").value, 400e6, 1e3);
  EXPECT_NEAR(known.parameter("yield_stress").standard_error, 20e6, 1e4);
  EXPECT_EQ(known.parameter("yield_stress").verdict(), Verdict::FromPrior);
  // Tied, the torsional yield stress follows that of tension.
  const WeightedTarget twist = twisted(6, 1.0, 9);
  SceneFitOptions tied{.parameters = stiffness_and_yield(), .starts = 1};
  tied.parameters.push_back(free_parameter("shear_yield_stress", 1e6, 2e9));
  tied.parameters[2].role = ParameterRole::Tied;
  tied.parameters[2].tied_to = tied.parameters[1].field;
  tied.parameters[2].factor = 1.0 / std::sqrt(3.0);
  const SceneFitResult by_tie = fit_scene(twist.setup, twist.target, tied);
  const SceneFitResult by_default =
      fit_scene(twist.setup, twist.target, {.parameters = stiffness_and_yield(), .starts = 1});
  EXPECT_NEAR(by_tie.parameter("yield_stress").value, by_default.parameter("yield_stress").value,
              1e-6 * by_default.parameter("yield_stress").value);
}

}  // namespace
}  // namespace plastica::calibrate
