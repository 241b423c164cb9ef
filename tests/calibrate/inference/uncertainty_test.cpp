#include "calibrate/inference/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "plastica/theory/statistics.hpp"
#include "tests/calibrate/fit/targets.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::calibrate {
namespace {

using namespace plastica::testing;

void add_normal_noise(Target& target, std::uint64_t seed, double deviation) {
  Noise noise(seed);
  for (double& s : target.corrected.stress) s += noise(deviation);
}

/// An elastic line with noise, 200 GPa up to 0.1 %.
Target line_of_modulus(double deviation) {
  const std::vector<double> strain = ramp(40, 0.001);
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(200e9 * e);
  Target target = target_of(strain, stress);
  add_normal_noise(target, 11, deviation);
  return target;
}

TEST(Uncertainty, IsThatOfARegressionWhereTheModelIsALine) {
  const Target target = line_of_modulus(2e6);
  FitOptions options =
      fit_of({free_parameter("youngs_modulus"), fixed_parameter("yield_stress", 1e12)});
  options.objective = Objective::LeastSquares;
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.status, FitStatus::Fitted) << result.reason;

  const Curve& curve = target.corrected;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    product += curve.strain[i] * curve.stress[i];
    square += curve.strain[i] * curve.strain[i];
  }
  const double slope = product / square;
  double residual = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    residual += std::pow(curve.stress[i] - slope * curve.strain[i], 2);
  }
  const double error = std::sqrt(residual / 39.0 / square);
  const FittedParameter& modulus = result.parameter("youngs_modulus");
  EXPECT_NEAR(modulus.value, slope, tolerance(1e-9 * slope));
  EXPECT_NEAR(modulus.standard_error, error, tolerance(1e-7 * error));
  // Student's t for 39 degrees of freedom and 95 % (tables: 2.0227).
  EXPECT_NEAR(modulus.interval_high - modulus.value, 2.0227 * error, tolerance(1e-4 * error));
  EXPECT_NEAR(modulus.value - modulus.interval_low, 2.0227 * error, tolerance(1e-4 * error));

  options.noise = 2e6;
  options.confidence = 0.99;
  const FitResult known = fit_target(target, options);
  const double expected = 2e6 / std::sqrt(square);
  const FittedParameter& with_noise = known.parameter("youngs_modulus");
  EXPECT_NEAR(with_noise.standard_error, expected, tolerance(1e-9 * expected));
  EXPECT_NEAR(with_noise.interval_high - with_noise.value, 2.5758293035 * expected,
              tolerance(1e-8 * expected));
}

constexpr int kFits = 300;

/// What 300 fits of an ideal-plastic curve with seeded noise say: the spread of a parameter's
/// values over the mean of its standard errors, and how many intervals hold the truth.
struct Spread {
  double young = 0.0;
  double yield = 0.0;
  int young_held = 0;
  int yield_held = 0;
};

/// @param strain_noise, fineness  besides 3 MPa of the stress; of the samples
Spread spread_of(const FitOptions& options, double strain_noise = 0.0, std::size_t fineness = 1) {
  std::vector<double> strain = path({0.0014}, 28 * fineness);
  const std::vector<double> plateau =
      ramp(12 * fineness + 1, 0.01);  // coarser: unequal strain-path weights
  for (const double e : plateau) {
    if (e > 0.0) strain.push_back(0.0014 + e);
  }
  const std::vector<double> stress = ideal_curve(strain, 200e9, 300e6);
  double sum[2] = {};
  double square[2] = {};
  double error[2] = {};
  int held[2] = {};
  for (int i = 0; i < kFits; ++i) {
    Target target = target_of(strain, stress);
    add_normal_noise(target, 1000 + static_cast<std::uint64_t>(i), 3e6);
    Noise of_strain(2000 + static_cast<std::uint64_t>(i));
    for (double& e : target.corrected.strain) e += of_strain(strain_noise);
    const FitResult result = fit_target(target, options);
    EXPECT_EQ(result.status, FitStatus::Fitted);
    const double truth[2] = {200e9, 300e6};
    const char* names[2] = {"youngs_modulus", "yield_stress"};
    for (int k = 0; k < 2; ++k) {
      const FittedParameter& p = result.parameter(names[k]);
      sum[k] += p.value;
      square[k] += p.value * p.value;
      error[k] += p.standard_error;
      held[k] += p.interval_low <= truth[k] && truth[k] <= p.interval_high ? 1 : 0;
    }
  }
  const auto ratio = [&](int k) {
    const double mean = sum[k] / kFits;
    return std::sqrt((square[k] - kFits * mean * mean) / (kFits - 1)) / (error[k] / kFits);
  };
  return {ratio(0), ratio(1), held[0], held[1]};
}

// The standard deviation of 300 normal samples scatters by 1/sqrt(600) = 4.1 %; 15 % is 3.7 of
// that, which one test in 2000 would exceed by chance (the samples are seeded, so none does).
constexpr double kChance = 0.15;

TEST(Uncertainty, MatchesTheSpreadOfFitsByLeastSquares) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  const Spread spread = spread_of(options);
  EXPECT_NEAR(spread.young, 1.0, tolerance(kChance));
  EXPECT_NEAR(spread.yield, 1.0, tolerance(kChance));
}

// Noise of 40 microstrain is 8 MPa on the elastic part and nothing on the plateau. The samples
// there are 25 microstrain apart; of 300 intervals of 95 % the binomial leaves out 15 +- 3.8. Along
// the strain path a few samples decide on E, of whose residuals little is left: HC3 makes up for
// more than that, by a fifth.
TEST(Uncertainty, MatchesTheSpreadOfFitsWithNoiseOfTheStrain) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  for (const Objective objective : {Objective::LeastSquares, Objective::Path}) {
    options.objective = objective;
    const Spread spread = spread_of(options, 4e-5, 2);
    const double beyond = objective == Objective::Path ? 0.2 : 0.0;
    EXPECT_LE(spread.young, 1.0 + tolerance(kChance));
    EXPECT_GE(spread.young, 1.0 - beyond - tolerance(kChance));
    EXPECT_NEAR(spread.yield, 1.0, tolerance(kChance));
    EXPECT_GE(spread.young_held, kFits - 15 - 12);
    EXPECT_GE(spread.yield_held, kFits - 15 - 12);
  }
}

TEST(Uncertainty, MatchesTheSpreadOfFitsWithAKnownNoise) {
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  options.noise = 3e6;
  const Spread spread = spread_of(options);
  EXPECT_NEAR(spread.young, 1.0, tolerance(kChance));
  EXPECT_NEAR(spread.yield, 1.0, tolerance(kChance));
}

TEST(Uncertainty, MatchesTheSpreadOfFitsWithGivenWeights) {
  // The plateau counts less from 0.5 % on, and its end not at all.
  FitOptions options = fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")});
  options.objective = Objective::LeastSquares;
  options.weights = {{0.001, 0.5}, {0.005, 0.2}, {0.011, 0.0}};
  const Spread free = spread_of(options);
  EXPECT_NEAR(free.young, 1.0, tolerance(kChance));
  EXPECT_NEAR(free.yield, 1.0, tolerance(kChance));
  options.noise = 3e6;
  const Spread known = spread_of(options);
  EXPECT_NEAR(known.young, 1.0, tolerance(kChance));
  EXPECT_NEAR(known.yield, 1.0, tolerance(kChance));
}

TEST(Uncertainty, IsThatOfAWeightedRegressionWhereTheModelIsALine) {
  const Target target = line_of_modulus(2e6);
  FitOptions options =
      fit_of({free_parameter("youngs_modulus"), fixed_parameter("yield_stress", 1e12)});
  options.objective = Objective::LeastSquares;
  options.weights = {{0.0003, 4.0}, {0.0008, 0.0}};
  double a = 0.0;        // sum w e^2
  double b = 0.0;        // sum w^2 e^2
  double product = 0.0;  // sum w e s
  double count = 0.0;
  const Curve& curve = target.corrected;
  const auto weight = [](double e) { return e < 0.0003 ? 1.0 : e < 0.0008 ? 4.0 : 0.0; };
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double w = weight(curve.strain[i]);
    a += w * curve.strain[i] * curve.strain[i];
    b += w * w * curve.strain[i] * curve.strain[i];
    product += w * curve.strain[i] * curve.stress[i];
    count += w > 0.0;
  }
  const double slope = product / a;
  double squares = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (weight(curve.strain[i]) == 0.0) continue;
    squares += std::pow(curve.stress[i] - slope * curve.strain[i], 2);
  }
  const FitResult found = fit_target(target, options);
  EXPECT_NEAR(found.parameter("youngs_modulus").value, slope, tolerance(1e-9 * slope));
  const double error = std::sqrt(squares / (count - 1.0) * b) / a;
  EXPECT_NEAR(found.parameter("youngs_modulus").standard_error, error, tolerance(1e-7 * error));

  options.noise = 2e6;  // independent errors of that size, whatever the weights
  const double known = 2e6 * std::sqrt(b) / a;
  EXPECT_NEAR(fit_target(target, options).parameter("youngs_modulus").standard_error, known,
              tolerance(1e-9 * known));
}

TEST(Uncertainty, MatchesTheSpreadOfFitsAlongTheStrainPath) {
  const Spread spread =
      spread_of(fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  EXPECT_NEAR(spread.young, 1.0, tolerance(kChance));
  EXPECT_NEAR(spread.yield, 1.0, tolerance(kChance));
}

/// Names of the free parameters that a fit calls not identified.
std::string unidentified(const FitResult& result) {
  std::string names;
  for (const FittedParameter& p : result.parameters) {
    if (!p.identified) {
      names += p.name() + " ";
      EXPECT_TRUE(std::isnan(p.standard_error) && std::isnan(p.interval_low) &&
                  std::isnan(p.interval_high));
      const std::string warning =
          p.name() + " is not identified: the curves do not depend on it by itself";
      EXPECT_EQ(std::count(result.warnings.begin(), result.warnings.end(), warning), 1);
    }
  }
  return names;
}

TEST(Uncertainty, YieldAboveTheCurveIsNotIdentified) {
  const FitResult result =
      fit_target(line_of_modulus(0.0),
                 fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress", 500e6)}));
  EXPECT_EQ(unidentified(result), "yield_stress ");
  EXPECT_TRUE(result.parameter("youngs_modulus").has_error());
  // The fitted curve is the model that was compared, not one with a default yield stress.
  FitOptions strong =
      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress", 9e8)});
  const std::vector<double> strain = ramp(40, 0.003);
  std::vector<double> stress;
  for (const double e : strain) stress.push_back(200e9 * e);
  const FitResult high = fit_target(target_of(strain, stress), strong);
  EXPECT_EQ(unidentified(high), "yield_stress ");
  EXPECT_NEAR(high.fitted.stress.back(), 600e6, tolerance(1e-3));
}

TEST(Uncertainty, YieldThatOnlyTheNoiseOfTheLastSamplesShowsIsNotIdentified) {
  // Of curves that stay elastic every other one ends below its line, where a plateau of a sample or
  // two costs less. 95 % of them must be told from a yield; with 40 the binomial leaves 34.
  int reported = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Target target = line_of_modulus(0.0);
    add_normal_noise(target, 500 + seed, 1e6);
    const FitResult result = fit_target(
        target, fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
    ASSERT_EQ(result.status, FitStatus::Fitted);
    const FittedParameter& yield = result.parameter("yield_stress");
    if (yield.judgement->verdict != Verdict::NotIdentified) continue;
    ++reported;
    EXPECT_FALSE(yield.has_error());
    EXPECT_TRUE(result.parameter("youngs_modulus").has_error());
  }
  EXPECT_GE(reported, 34);
  // Two samples far below the line are a yield.
  Target target = line_of_modulus(1e6);
  for (std::size_t i = 38; i < 40; ++i) target.corrected.stress[i] = 175e6;
  const FitResult result = fit_target(
      target, fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress")}));
  EXPECT_TRUE(result.parameter("yield_stress").identified);
}

TEST(Uncertainty, TangentModulusIsNotIdentifiedWithoutAPlasticPart) {
  FitOptions options =
      fit_of({free_parameter("youngs_modulus"), fixed_parameter("yield_stress", 500e6),
              free_parameter("tangent_modulus")});
  options.setup.scene.material.hardening.law = HardeningLaw::Linear;
  EXPECT_EQ(unidentified(fit_target(line_of_modulus(1e5), options)), "tangent_modulus ");
}

TEST(Uncertainty, ParametersOfWhichOnlyACombinationIsIdentifiableAreNotIdentified) {
  const std::vector<double> strain = ramp(41, 0.02);
  Target torsion = target_of(strain, ideal_curve(strain, 80e9, 170e6), Deformation::Torsion);
  // G = E/2(1+nu): E and nu together, while the yield stress is identifiable by itself.
  add_normal_noise(torsion, 3, 1e5);
  const FitResult result =
      fit_target(torsion, fit_of({free_parameter("youngs_modulus"), free_parameter("poisson_ratio"),
                                  free_parameter("yield_stress")}));
  EXPECT_EQ(unidentified(result), "youngs_modulus poisson_ratio ");
  EXPECT_TRUE(result.parameter("yield_stress").has_error());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isnan(result.correlation[i]));
    EXPECT_TRUE(std::isnan(result.correlation[3 * i + 1]));
  }
  EXPECT_EQ(result.correlation[8], 1.0);
}

TEST(Uncertainty, ATestSeesItsOwnYieldStressAlone) {
  const std::vector<double> strain = ramp(41, 0.02);
  const FitOptions options =
      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
              free_parameter("shear_yield_stress")});
  Target tension = target_of(strain, ideal_curve(strain, 200e9, 300e6));
  Target torsion = target_of(strain, ideal_curve(strain, 80e9, 170e6), Deformation::Torsion);
  add_normal_noise(tension, 4, 1e5);
  add_normal_noise(torsion, 5, 1e5);
  EXPECT_EQ(unidentified(fit_target(tension, options)), "shear_yield_stress ");
  EXPECT_EQ(unidentified(fit_target(torsion, options)), "yield_stress ");
  FitOptions tied = options;
  tied.parameters[2] = tied_parameter("shear_yield_stress", "yield_stress", 0.6);
  const FitResult result = fit_target(torsion, tied);
  EXPECT_EQ(unidentified(result), "");
  const FittedParameter& yield = result.parameter("yield_stress");
  const FittedParameter& shear = result.parameter("shear_yield_stress");
  EXPECT_NEAR(shear.value, 170e6, tolerance(0.2e6));
  EXPECT_NEAR(shear.standard_error, 0.6 * yield.standard_error, tolerance(1e-6));
  EXPECT_NEAR(shear.interval_high - shear.value, 0.6 * (yield.interval_high - yield.value),
              tolerance(1e-6));
}

TEST(Uncertainty, BreakStrainCarriesItsSamplingInterval) {
  const std::vector<double> strain = ramp(81, 0.02);
  const auto fitted = [&](double deviation, Deformation test) {
    Target target = target_of(strain, ideal_curve(strain, 200e9, 300e6), test);
    add_normal_noise(target, 6, deviation);
    break_at(target, 0.0206, 0.0188);
    return fit_target(target,
                      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
                              free_parameter("break_strain")}));
  };
  // Without noise the interval is all there is: h = 0.0003, sqrt(h^2/3) of a uniform break.
  const FitResult exact = fitted(0.0, Deformation::Tension);
  const FittedParameter& sharp = exact.parameter("break_strain");
  EXPECT_NEAR(sharp.value, 0.0203 - 300e6 / 200e9, tolerance(1e-9));
  EXPECT_NEAR(sharp.standard_error, 0.0003 / std::sqrt(3.0), tolerance(1e-9));
  // Evenly likely within h, 95 % of the breaks lie within 0.95 h.
  EXPECT_NEAR(sharp.interval_high - sharp.value, 0.95 * 0.0003, tolerance(1e-9));
  EXPECT_NEAR(sharp.value - sharp.interval_low, 0.95 * 0.0003, tolerance(1e-9));

  // With noise the model's p = strain - Y/E adds its own variance.
  const FitResult noisy = fitted(6e6, Deformation::Tension);
  const FittedParameter& young = noisy.parameter("youngs_modulus");
  const FittedParameter& yield = noisy.parameter("yield_stress");
  const double by_young = yield.value / (young.value * young.value) * young.standard_error;
  const double by_yield = -yield.standard_error / young.value;
  const double rho = noisy.correlation[1];
  const double variance =
      by_young * by_young + by_yield * by_yield + 2.0 * rho * by_young * by_yield;
  const double sampling = 0.0003 * 0.0003 / 3.0;
  const FittedParameter& blurred = noisy.parameter("break_strain");
  EXPECT_NEAR(blurred.standard_error, std::sqrt(variance + sampling), tolerance(1e-12));
  EXPECT_NEAR(blurred.noise_error, std::sqrt(variance), tolerance(1e-12));
  // The error is s t + h u, t Student's with 79 degrees of freedom and u uniform within -1 … 1: the
  // probability of less than q is the mean of Student's over (q - h)/s … (q + h)/s.
  const double s = std::sqrt(variance);
  const double q = blurred.interval_high - blurred.value;
  double below = 0.0;
  constexpr int kPoints = 20000;
  for (int i = 0; i < kPoints; ++i) {
    const double u = (2.0 * i + 1.0) / kPoints - 1.0;
    below += theory::student_t_cdf((q - 0.0003 * u) / s, 79.0) / kPoints;
  }
  EXPECT_NEAR(below, 0.975, tolerance(1e-8));

  // A strain of tension is smaller than that of torsion by sqrt(3), and so is its error.
  const FitResult torsion = fitted(0.0, Deformation::Torsion);
  EXPECT_NEAR(torsion.parameter("break_strain").value, 0.0188 / std::sqrt(3.0), tolerance(1e-9));
  EXPECT_NEAR(torsion.parameter("break_strain").standard_error, 0.0001, tolerance(1e-9));
}

TEST(Uncertainty, CorrelationsAreSymmetricAndAtMostOne) {
  const std::vector<double> strain = path({0.01, -0.01, 0.01}, 30);
  FitOptions options =
      fit_of({free_parameter("youngs_modulus"), free_parameter("yield_stress"),
              free_parameter("tangent_modulus"), free_parameter("kinematic_fraction"),
              free_parameter("break_strain")});
  Material& material = options.setup.scene.material;
  material.hardening = {HardeningLaw::Linear, 4e9, 0.6};
  Target target = target_like(options, Deformation::Tension, strain);
  target.loading = Loading::Cyclic;
  add_normal_noise(target, 7, 2e6);
  break_at(target, 0.0101, 0.008);
  const FitResult result = fit_target(target, options);
  ASSERT_EQ(result.correlation.size(), 25U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(result.correlation[6 * i], 1.0);
    for (std::size_t j = 0; j < 5; ++j) {
      EXPECT_NEAR(result.correlation[5 * i + j], result.correlation[5 * j + i], 1e-12);
      EXPECT_LE(std::fabs(result.correlation[5 * i + j]), 1.0 + 1e-12);
      EXPECT_NE(result.correlation[5 * i + j], 0.0);
    }
  }
}

}  // namespace
}  // namespace plastica::calibrate
