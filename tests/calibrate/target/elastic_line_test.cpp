#include "calibrate/target/elastic_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "calibrate/target/make.hpp"

namespace plastica::calibrate {
namespace {

/// Elastic to its yield stress, then s = yield + strength ep^exponent; evenly spaced strains.
struct HardeningLine {
  const char* material;
  double modulus, yield, strength, exponent, end;
};

constexpr HardeningLine kAustenitic{"austenitic steel", 193e9, 240e6, 1000e6, 0.75, 0.5};
constexpr HardeningLine kCompressed{"aluminium in compression", 69e9, 120e6, 400e6, 0.6, 0.6};
constexpr HardeningLine kHot{"hot soft metal", 45e9, 8e6, 20e6, 0.3, 0.5};
constexpr HardeningLine kPolymer{"polymer", 2.3e9, 40e6, 20e6, 1.0, 0.8};

/// @param samples  on the elastic part; as many times more on all of it as it is longer, or 400
Curve curve_of(const HardeningLine& of, int samples, double noise = 0.0) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  Curve curve;
  const auto add = [&](double strain, double stress) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress + noise * of.yield * normal(random));
  };
  const double yield_strain = of.yield / of.modulus;
  for (int i = 0; i <= samples; ++i) add(yield_strain * i / samples, of.yield * i / samples);
  for (int i = 1; i <= 400; ++i) {
    const double plastic = of.end * i / 400.0;
    const double stress = of.yield + of.strength * std::pow(plastic, of.exponent);
    add(stress / of.modulus + plastic, stress);
  }
  return curve;
}

/// Worked by hand: the elastic part is exactly straight, so E is the material's, the toe nothing,
/// and the proof stress that of 0.2 % on the hardening curve.
TEST(ElasticLine, IsBelowTheKneeHoweverStronglyACurveHardens) {
  for (const HardeningLine& of : {kAustenitic, kCompressed, kHot, kPolymer}) {
    for (const int samples : {8, 20, 100}) {
      for (const double noise : {0.0, 0.005}) {
        const Target target = make_target("t", curve_of(of, samples, noise));
        const std::string what = of.material + (", " + std::to_string(samples)) + ", noise " +
                                 std::to_string(noise) + ": " + target.reason;
        ASSERT_EQ(target.status, TargetStatus::Ready) << what;
        const Characteristics& c = target.characteristics;
        EXPECT_NEAR(*c.youngs_modulus / of.modulus, 1.0, noise > 0.0 ? 0.05 : 1e-9) << what;
        ASSERT_TRUE(c.proof_stress.has_value()) << what;
        // Its line is crossed where the permanent strain is 0.2 %, between two samples.
        const double proof = of.yield + of.strength * std::pow(0.002, of.exponent);
        EXPECT_NEAR(*c.proof_stress / proof, 1.0, 0.02) << what;
        EXPECT_LT(c.modulus_window_high, proof) << what;
        for (const Correction& correction : target.corrections) {
          if (correction.kind == "toe") {
            EXPECT_LT(std::abs(correction.amount), 2e-4) << what;
          }
        }
      }
    }
  }
}

/// One or two samples on the elastic part say nothing of E, and no number may be made of them.
TEST(ElasticLine, IsNotFoundWhereTheElasticPartHasNoSamples) {
  for (const HardeningLine& of : {kAustenitic, kCompressed, kHot}) {
    for (const int samples : {1, 2}) {
      const Target target = make_target("t", curve_of(of, samples));
      const std::string what = of.material + (", " + std::to_string(samples));
      EXPECT_NE(target.status, TargetStatus::Ready) << what;
      if (!target.characteristics.youngs_modulus) continue;
      EXPECT_NEAR(*target.characteristics.youngs_modulus / of.modulus, 1.0, 0.05) << what;
    }
  }
}

/// Ramberg and Osgood's curve is nowhere straight: the nearer to its foot, the nearer to E.
TEST(ElasticLine, MovesDownACurveThatBends) {
  for (const double exponent : {4.0, 5.0, 8.0, 20.0}) {
    Curve curve;
    for (int i = 0; i <= 600; ++i) {
      const double stress = 240e6 * std::pow(250.0, 1.0 / exponent) * i / 600.0;
      curve.strain.push_back(stress / 193e9 + 0.002 * std::pow(stress / 240e6, exponent));
      curve.stress.push_back(stress);
    }
    const Target target = make_target("t", curve);
    const bool is_warned = std::ranges::any_of(target.warnings, [](const std::string& warning) {
      return warning.starts_with("the curve bends where Young's modulus is measured");
    });
    EXPECT_NEAR(*target.characteristics.youngs_modulus / 193e9, 1.0, is_warned ? 0.25 : 0.1)
        << exponent;
    EXPECT_EQ(is_warned, exponent < 5.0) << exponent;
    EXPECT_NEAR(*target.characteristics.proof_stress / 240e6, 1.0, exponent < 8.0 ? 0.04 : 0.01)
        << exponent;
  }
}

/// A steel of 205 GPa whose strain is noisy, as measured by a camera.
Curve noisy_steel(unsigned seed, double noise) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, 1.0);
  Curve curve;
  for (int i = 0; i < 1500; ++i) {
    const double strain = 0.03 * std::pow(i / 1500.0, 1.5);
    const double stress = std::min(205e9 * strain, 400e6 + 9e8 * strain);
    curve.strain.push_back(strain + noise * normal(random));
    curve.stress.push_back(stress + 0.3e6 * normal(random));
  }
  return curve;
}

/// The regression of the stress alone gives 186, and samples that are dropped where the noisy
/// strain falls leave a slope of 184 GPa.
TEST(ElasticLine, IsNoFlatterForNoiseInTheStrain) {
  constexpr int kSeeds = 40;
  double modulus = 0.0, squares = 0.0, slope = 0.0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const Target target = make_target("t", noisy_steel(seed, 1e-4));
    ASSERT_EQ(target.status, TargetStatus::Ready) << target.reason;
    const double e = *target.characteristics.youngs_modulus;
    modulus += e / kSeeds;
    squares += e * e / kSeeds;
    // Through the origin, of the samples that a fit gets.
    double sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < target.corrected.size(); ++i) {
      if (target.corrected.strain[i] > 0.0016) break;
      sxx += target.corrected.strain[i] * target.corrected.strain[i];
      sxy += target.corrected.strain[i] * target.corrected.stress[i];
    }
    slope += sxy / sxx / kSeeds;
  }
  const double error = std::sqrt((squares - modulus * modulus) / kSeeds);
  EXPECT_NEAR(modulus, 205e9, 3.0 * error);
  EXPECT_LT(error, 2e9);
  EXPECT_NEAR(slope, 205e9, 2.5e9);
}

/// A strain that was zeroed under load, below a row of zeros.
TEST(ElasticLine, IsFoundAboveAPreloadBelowARowOfZeros) {
  Curve curve{{0.0}, {0.0}};
  for (int i = 0; i <= 300; ++i) {
    const double strain = 1e-4 * i;
    curve.strain.push_back(strain);
    curve.stress.push_back(std::min(45e6 + 210e9 * strain, 300e6 + 1e9 * strain));
  }
  const Target target = make_target("preload", curve);
  ASSERT_EQ(target.status, TargetStatus::Ready) << target.reason;
  EXPECT_NEAR(*target.characteristics.youngs_modulus, 210e9, 2e9);
}

std::size_t outliers_of(const Target& target) {
  const auto found = std::ranges::find(target.repairs, "outliers", &Repair::kind);
  return found == target.repairs.end() ? 0 : found->count;
}

constexpr HardeningLine kSteel{"steel", 200e9, 300e6, 600e6, 0.5, 0.1};

// The truth is the curve without it, whose E differs by what one sample says.
TEST(ElasticLine, DoesNotMoveForALoneDropoutOrSpike) {
  for (const int samples : {15, 40, 150}) {
    const Curve clean = curve_of(kSteel, samples, 0.002);
    const Characteristics& c = make_target("clean", clean).characteristics;
    ASSERT_EQ(outliers_of(make_target("clean", clean)), 0U);
    for (const double place : {0.25, 0.4, 0.55, 0.75}) {
      const auto at = static_cast<std::size_t>(place * samples);
      for (const double wrong : {0.0, 0.5 * clean.stress[at], clean.stress[at] + 60e6}) {
        Curve curve = clean;
        curve.stress[at] = wrong;
        const Target target = make_target("lone", curve);
        EXPECT_EQ(outliers_of(target), 1U) << samples << " " << at << " " << wrong;
        const Characteristics& lone = target.characteristics;
        EXPECT_NEAR(*lone.youngs_modulus, *c.youngs_modulus, *c.youngs_modulus_stderr);
        EXPECT_NEAR(lone.modulus_window_high / c.modulus_window_high, 1.0, 1e-3);
      }
    }
  }
}

TEST(ElasticLine, IsOfAllSamplesAtCornersAndPeaks) {
  // A sharp corner at the yield stress, sampled coarsely beyond it; and an upper yield point of one
  // sample, before a fall within one or two.
  for (const int samples : {10, 40, 200}) {
    for (const double fall : {0.0, 0.03, 0.1, 0.2}) {
      for (const int steps : {1, 2}) {
        Curve curve;
        for (int i = 0; i <= samples; ++i) {
          curve.strain.push_back(0.0015 * i / samples);
          curve.stress.push_back(300e6 * i / samples);
        }
        for (int i = 1; i <= 100; ++i) {
          curve.strain.push_back(0.0015 + 5e-4 * i);
          const double fallen = fall * std::min(1.0, static_cast<double>(i) / steps);
          curve.stress.push_back(300e6 * (1.0 - fallen) + 0.4e6 * i);
        }
        EXPECT_EQ(outliers_of(make_target("corner", curve)), 0U)
            << samples << " " << fall << " " << steps;
      }
    }
  }
}

// After its break the machine drives back, with nothing in the grips.
TEST(ElasticLine, DoesNotMoveForRowsAfterTheEndOfTheTest) {
  const Curve tested = curve_of(kSteel, 40, 0.002);
  const double end = tested.strain.back();
  Curve broken = tested;
  const auto add = [&](Curve& curve, double strain, int i) {
    curve.strain.push_back(strain);
    curve.stress.push_back(i % 2 == 0 ? 0.3e6 : -0.2e6);
  };
  for (int i = 0; i < 3; ++i) add(broken, end + 1e-4 * (i + 1), i);
  const Target alone = make_target("alone", broken);
  Curve back = broken, at_once = broken;
  for (int i = 0; i < 50; ++i) add(back, end * (1.0 - i / 49.0), i);
  for (int i = 0; i < 10; ++i) add(at_once, 1e-6 * i, i);
  for (const Curve& curve : {back, at_once}) {
    const Target target = make_target("after", curve);
    const Characteristics &a = alone.characteristics, &b = target.characteristics;
    EXPECT_NEAR(b.modulus_window_high / a.modulus_window_high, 1.0, 1e-3);
    EXPECT_NEAR(*b.youngs_modulus / *a.youngs_modulus, 1.0, 1e-6);
    EXPECT_NEAR(*b.proof_stress / *a.proof_stress, 1.0, 1e-3);
    EXPECT_NEAR(*b.break_strain, *a.break_strain, 1e-9);
  }
}

// A window of measured stresses chooses samples by their noise: the slopes of many tests would
// come out 0.4 % too small together, each within its own error.
TEST(ElasticLine, IsNotBentByTheNoiseThatDecidesWhichSamplesLieInTheWindow) {
  constexpr int kTests = 500;
  struct Noise {
    double strain, stress;
  };
  for (const auto& [of_strain, of_stress] : {Noise{0.0, 1e6}, Noise{0.0, 3e6}, Noise{2e-5, 3e6}}) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, 1.0);
    double sum = 0.0, squares = 0.0, zero = 0.0, zero_squares = 0.0;
    for (int test = 0; test < kTests; ++test) {
      Curve curve;
      for (int i = 0; i < 300; ++i) {
        const double strain = 0.01 * i / 299.0;
        curve.strain.push_back(strain + of_strain * normal(random));
        curve.stress.push_back(std::min(200e9 * strain, 400e6) + of_stress * normal(random));
      }
      const auto line = find_elastic_line(curve, Loading::Monotonic, of_stress, TargetOptions{});
      ASSERT_TRUE(line.has_value());
      const double off = line->modulus / 200e9 - 1.0;
      sum += off;
      squares += off * off;
      zero += line->zero_strain;
      zero_squares += line->zero_strain * line->zero_strain;
    }
    const std::string what = std::to_string(of_strain) + ", " + std::to_string(of_stress / 1e6);
    EXPECT_LT(std::abs(sum), 3.0 * std::sqrt(squares)) << what << ": " << sum / kTests;
    EXPECT_LT(std::abs(zero), 3.0 * std::sqrt(zero_squares)) << what << ": " << zero / kTests;
  }
}

}  // namespace
}  // namespace plastica::calibrate
