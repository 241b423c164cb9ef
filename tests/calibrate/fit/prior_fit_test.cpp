#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/fit/scene_fit.hpp"
#include "calibrate/inference/verdict.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/message.hpp"
#include "tests/support/tolerance.hpp"

/// Fits of curves whose parameters state priors.
namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

constexpr double kStressNoise = 20e6;
constexpr std::size_t kSamples = 40;

Parameter with_prior(Parameter p, double mean, double standard_deviation) {
  p.prior = Prior{mean, standard_deviation};
  return p;
}

/// 200 GPa and residuals that change their sign, so that none is like its neighbour.
Target alternating() {
  std::vector<double> strain = ramp(kSamples, 0.001), stress;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    stress.push_back(200e9 * strain[i] + (i % 2 == 0 ? kStressNoise : -kStressNoise));
  }
  return target_of(strain, stress);
}

FitOptions elastic(double mean, double standard_deviation) {
  FitOptions options =
      fit_of({with_prior(free_parameter("youngs_modulus"), mean, standard_deviation)});
  options.setup.scene.material.yield_stress = 1e12;
  options.objective = Objective::LeastSquares;
  // Above what is left, so that it is this noise that counts.
  options.noise = 1.01 * kStressNoise;
  options.modulus_prior = false;
  return options;
}

/// A straight line and a normal prior: the posterior is normal, too, with the sums of both's
/// information.
TEST(PriorFit, IsThePosteriorOfAStraightLine) {
  const Target target = alternating();
  for (const double mean : {190e9, 230e9}) {
    for (const double deviation : {0.5e9, 5e9, 50e9}) {
      const FitOptions options = elastic(mean, deviation);
      const FitResult result = fit_target(target, options);
      ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;
      double square = 0.0, product = 0.0;
      for (std::size_t i = 0; i < kSamples; ++i) {
        square += target.corrected.strain[i] * target.corrected.strain[i];
        product += target.corrected.strain[i] * target.corrected.stress[i];
      }
      const double of_curve = square / (*options.noise * *options.noise);
      const double of_prior = 1.0 / (deviation * deviation);
      const double all = of_curve + of_prior;
      const FittedParameter& modulus = result.parameter("youngs_modulus");
      const double posterior =
          (product / (*options.noise * *options.noise) + of_prior * mean) / all;
      EXPECT_NEAR(modulus.value, posterior, tolerance(1e-6 * posterior)) << mean << deviation;
      EXPECT_NEAR(modulus.standard_error, 1.0 / std::sqrt(all), tolerance(1e-6 * modulus.value));
      const bool from_prior = of_prior > of_curve;
      if (modulus.verdict() != Verdict::Weak) {
        EXPECT_EQ(modulus.verdict() == Verdict::FromPrior, from_prior) << deviation;
      }
      if (from_prior) {
        EXPECT_NEAR(modulus.verdict_number(), of_prior / all, tolerance(1e-6));
      }
      ASSERT_TRUE(result.stated_priors);
      EXPECT_NEAR(result.stated_priors->squared, std::pow((posterior - mean) / deviation, 2),
                  tolerance(1e-3));
    }
  }
}

/// The other road: the same samples through a scene of the same coupon.
TEST(PriorFit, IsThatThroughAScene) {
  const Target target = alternating();
  const FitOptions options = elastic(215e9, 4e9);
  SceneTarget through;
  through.name = "same";
  through.kind = Abscissa::Strain;
  through.ordinate_probe = "stress";
  through.abscissa_is = Dimension::Strain;
  through.ordinate_is = Dimension::Stress;
  through.abscissa = target.corrected.strain;
  through.ordinate = target.corrected.stress;
  through.noise = options.noise;
  plastica::Setup setup = options.setup;
  setup.scene.drive.strain = {0.0, 0.001};
  setup.scene.probes = {{"stress", ProbeQuantity::Stress}};
  SceneFitOptions scenes;
  scenes.parameters = options.parameters;
  scenes.parameters[0].lower = 100e9;
  scenes.parameters[0].upper = 400e9;
  scenes.segments_error = false;
  const FittedParameter there = fit_scene(setup, through, scenes).parameters.at(0);
  const FittedParameter here = fit_target(target, options).parameters.at(0);
  EXPECT_NEAR(here.value, there.value, tolerance(1e-6 * there.value));
  EXPECT_NEAR(here.noise_error, there.noise_error, tolerance(1e-6 * there.noise_error));
  EXPECT_EQ(here.verdict(), there.verdict());
}

/// What the curve does not depend on is what the prior says, above the largest stress, too.
TEST(PriorFit, DeterminesWhatTheCurveDoesNot) {
  const Target target = alternating();
  FitOptions options = elastic(200e9, 50e9);
  options.parameters.push_back(with_prior(free_parameter("yield_stress"), 380e6, 15e6));
  options.parameters[1].lower = 10e6;
  options.parameters[1].upper = 2e9;
  options.intervals.profile = true;
  options.intervals.bootstrap = 400;
  const FitResult result = fit_target(target, options);
  const FittedParameter& yield = result.parameter("yield_stress");
  EXPECT_NEAR(yield.value, 380e6, tolerance(380e6 * 1e-6));
  EXPECT_NEAR(yield.standard_error, 15e6, tolerance(15e6 * 1e-6));
  EXPECT_EQ(yield.verdict(), Verdict::FromPrior);
  EXPECT_NEAR(yield.verdict_number(), 1.0, tolerance(1e-9));
  // 1.96 standard deviations of a noise that is known.
  ASSERT_EQ(result.intervals.profiles.size(), 2u);
  EXPECT_NEAR(result.intervals.profiles[1].low, 380e6 - 1.96 * 15e6, tolerance(0.1e6));
  EXPECT_NEAR(result.intervals.profiles[1].high, 380e6 + 1.96 * 15e6, tolerance(0.1e6));
  EXPECT_NEAR(result.intervals.residuals.intervals.at(1).standard_error, 15e6, tolerance(2e6));
}

/// Noise at the end of an elastic curve makes a minimum below the largest stress: what a search
/// with a prior ends at must not cost more than the prior's mean, beside the elastic line of least
/// squares.
TEST(PriorFit, IsNoWorseThanThePriorsMean) {
  constexpr double kNoise = 3e6, kMean = 1000e6, kDeviation = 50e6;
  int at_mean = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, kNoise);
    const std::vector<double> strain = ramp(100, 4.5e-3);
    std::vector<double> stress;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const double e : strain) {
      stress.push_back(200e9 * e + normal(random));
      xx += e * e;
      xy += e * stress.back();
      yy += stress.back() * stress.back();
    }
    FitOptions options = fit_of({free_parameter("youngs_modulus"),
                                 with_prior(free_parameter("yield_stress"), kMean, kDeviation)});
    options.objective = Objective::LeastSquares;
    options.noise = kNoise;
    options.modulus_prior = false;
    const FitResult result = fit_target(target_of(strain, stress), options);
    ASSERT_TRUE(result.stated_priors) << seed;
    const double samples = static_cast<double>(strain.size());
    const double found =
        samples * std::pow(result.misfit_rms / kNoise, 2) + result.stated_priors->squared;
    EXPECT_LE(found, (yy - xy * xy / xx) / (kNoise * kNoise) + tolerance(1e-6)) << seed;
    at_mean += std::fabs(result.parameter("yield_stress").value - kMean) < 1e3 ? 1 : 0;
  }
  EXPECT_GT(at_mean, 10);
}

/// An exact curve leaves what it cannot tell to the prior as well.
TEST(PriorFit, DeterminesWhatAnExactCurveDoesNot) {
  const std::vector<double> strain = ramp(50, 0.001);
  FitOptions options = fit_of(
      {free_parameter("youngs_modulus"), with_prior(free_parameter("yield_stress"), 300e6, 20e6)});
  const FitResult result = fit_target(target_of(strain, ideal_curve(strain, 200e9, 1e12)), options);
  EXPECT_NEAR(result.parameter("youngs_modulus").value, 200e9, tolerance(1e-6 * 200e9));
  EXPECT_NEAR(result.parameter("yield_stress").value, 300e6, tolerance(0.3e6));
}

bool contradicts(const FitResult& result) {
  return std::ranges::any_of(result.warnings, [](const std::string& line) {
    return line.find("the curves contradict the prior of youngs_modulus") != std::string::npos;
  });
}

TEST(PriorFit, SaysThatTheCurveContradictsIt) {
  EXPECT_TRUE(contradicts(fit_target(alternating(), elastic(160e9, 2e9))));
  EXPECT_TRUE(contradicts(fit_target(alternating(), elastic(160e9, 0.2e9))));
  EXPECT_FALSE(contradicts(fit_target(alternating(), elastic(199e9, 2e9))));
}

TEST(PriorFit, RefusesWhatIsNoPrior) {
  const auto refused = [](Parameter p) {
    return message_of([&] {
      (void)fit_target(alternating(), fit_of({free_parameter("yield_stress"), std::move(p)}));
    });
  };
  EXPECT_EQ(refused(with_prior(free_parameter("youngs_modulus"), 200e9, 0.0)),
            "material.youngs_modulus = 0: the prior's standard deviation must be above 0");
  EXPECT_EQ(refused(with_prior(free_parameter("youngs_modulus"), NAN, 1e9)),
            "material.youngs_modulus = nan: the prior's mean must be a finite number");
  EXPECT_EQ(refused(with_prior(free_parameter("break_strain"), 0.1, 0.01)),
            "material.break_strain: cannot have a prior: a break strain is set, not searched");
}

}  // namespace
}  // namespace plastica::calibrate
