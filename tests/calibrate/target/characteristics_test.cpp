#include "calibrate/target/characteristics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibrate/target/make.hpp"
#include "plastica/base/check.hpp"
#include "tests/calibrate/target/curves.hpp"

namespace plastica::calibrate {
namespace {

using plastica::testing::IdealPlastic;
using plastica::testing::smooth_curve;

/// Elastic to 300 MPa, a fall by `drop` of it, and hardening from there to 400 MPa or not at all.
Curve with_yield_point(double drop, bool recovers) {
  Curve curve;
  for (int i = 0; i <= 30; ++i) {
    curve.strain.push_back(5e-5 * i);
    curve.stress.push_back(1e7 * i);
  }
  for (int i = 1; i <= 100; ++i) {
    curve.strain.push_back(1.5e-3 + 1e-3 * i);
    const double hardening = recovers && i > 20 ? 1.25e6 * (i - 20) : 0.0;
    curve.stress.push_back(300e6 * (1.0 - drop) + hardening);
  }
  return curve;
}

TEST(Characteristics, NoiseIsZeroOnStraightStretchesAndRightOnNormalNoise) {
  IdealPlastic test;
  EXPECT_LT(noise_of(test.curve().strain, test.curve().stress), 1.0);  // Pa; rounding alone
  test.noise = 0.01;
  test.plateau = 2000;
  EXPECT_NEAR(noise_of(test.curve().strain, test.curve().stress), 4e6, 0.4e6);
}

TEST(Characteristics, TheRegressionStatesItsWindowAndStandardError) {
  const Characteristics c = make_target("smooth", smooth_curve(4000)).characteristics;
  EXPECT_EQ(c.modulus_method, "regression");
  EXPECT_NEAR(c.youngs_modulus.value(), 70e9, 0.1e9);
  EXPECT_NEAR(c.modulus_window_low / c.proof_stress.value(), 0.2, 1e-3);
  EXPECT_NEAR(c.modulus_window_high / c.proof_stress.value(), 0.6, 1e-3);
  EXPECT_GT(c.youngs_modulus_stderr.value(), 0.0);
}

TEST(Characteristics, AModulusThatIsHardlyKnownIsNoNumber) {
  Characteristics c;
  EXPECT_FALSE(c.sound_modulus());
  c.youngs_modulus = 200e9;
  EXPECT_EQ(c.sound_modulus(), 200e9) << "given, or a chord";
  c.youngs_modulus_stderr = 10e9;
  EXPECT_EQ(c.sound_modulus(), 200e9);
  c.youngs_modulus_stderr = 10.1e9;
  EXPECT_FALSE(c.sound_modulus());
  c.youngs_modulus_stderr = NAN;
  EXPECT_FALSE(c.sound_modulus());
}

TEST(Characteristics, TheChordGoesThroughTheEndsOfItsWindow) {
  TargetOptions options;
  options.modulus_method = ModulusMethod::Chord;
  options.modulus_window = {50e6, 150e6};
  const Curve curve = with_yield_point(0.0, true);
  const Characteristics c = make_target("chord", curve, options).characteristics;
  EXPECT_EQ(c.modulus_method, "chord");
  EXPECT_NEAR(c.youngs_modulus.value(), 200e9, 1e3);
  EXPECT_EQ(c.modulus_window_low, 50e6);
  EXPECT_FALSE(c.youngs_modulus_stderr.has_value());
  options.modulus_window.reset();
  EXPECT_THROW(make_target("chord", curve, options), InputError);
}

TEST(Characteristics, AGivenModulusIsTakenAsItIs) {
  TargetOptions options;
  options.youngs_modulus = 69e9;
  const Characteristics c = make_target("given", smooth_curve(), options).characteristics;
  EXPECT_EQ(c.modulus_method, "given");
  EXPECT_EQ(c.youngs_modulus.value(), 69e9);
  options.youngs_modulus = -1.0;
  EXPECT_THROW(make_target("given", smooth_curve(), options), InputError);
}

TEST(Characteristics, TheProofStressIsInterpolatedAtTheLastCrossing) {
  // stress = 100 MPa + 1 GPa e crosses 100 GPa (e - 0.002) at e = 0.3/99.
  const std::vector<double> strain{0.0, 0.001, 0.002, 0.01};
  const std::vector<double> stress{0.0, 101e6, 102e6, 110e6};
  const auto proof = proof_stress(strain, stress, 100e9, 0.0, 0.002);
  EXPECT_NEAR(proof.value(), 100e6 + 1e9 * 0.3 / 99.0, 1.0);
  EXPECT_FALSE(proof_stress(strain, stress, 100e9, 0.0, 0.02).has_value());
}

TEST(Characteristics, TheOffsetOfTheProofStressCanBeSet) {
  TargetOptions options;
  options.offset = 0.01;
  const Curve curve = smooth_curve(2000);
  const auto later = make_target("1 %", curve, options).characteristics;
  EXPECT_EQ(later.offset, 0.01);
  EXPECT_GT(later.proof_stress.value(),
            make_target("0.2 %", curve).characteristics.proof_stress.value() + 3e6);
}

TEST(Characteristics, AYieldPointNeedsADropAboveTheThresholdAndARecovery) {
  const Characteristics c = make_target("drop", with_yield_point(0.02, true)).characteristics;
  EXPECT_EQ(c.reh.value(), 300e6);
  EXPECT_NEAR(c.rel.value(), 294e6, 1.0);
  EXPECT_FALSE(make_target("small", with_yield_point(0.001, true)).characteristics.reh);
  EXPECT_FALSE(make_target("falls on", with_yield_point(0.02, false)).characteristics.reh);
}

// Steel whose upper yield strength of 300 MPa it never reaches again: Rm is 290 MPa, of hardening.
TEST(Characteristics, RmComesAfterAYieldPointThatIsTheLargestStress) {
  Curve curve = with_yield_point(0.1, false);
  for (std::size_t i = 60; i < curve.size(); ++i) {
    curve.stress[i] += 20e6 * static_cast<double>(i - 60) / static_cast<double>(curve.size() - 61);
  }
  const Characteristics c = make_target("hump", curve).characteristics;
  EXPECT_EQ(c.reh.value(), 300e6);
  EXPECT_NEAR(c.rel.value(), 270e6, 1.0);
  EXPECT_NEAR(c.rm.value(), 290e6, 1.0);
  EXPECT_EQ(c.strain_at_rm.value(), curve.strain.back());
}

/// Steel of 205 GPa and ReH = 400 MPa, whose stress is `flow` of the strain after that, and
/// from 1.5 % on hardens by 120 MPa.
template <typename Flow>
Curve with_flow(const Flow& flow, double noise) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Curve curve;
  const auto add = [&](double strain, double stress) {
    curve.strain.push_back(strain);
    curve.stress.push_back(stress + noise * normal(random));
  };
  constexpr double kUpper = 400e6 / 205e9, kHardens = 0.015;
  for (int i = 0; i <= 60; ++i) add(kUpper * i / 60, 400e6 * i / 60);
  for (double after = 1e-4; after < 0.2; after += after < kHardens ? 1e-4 : 1e-3) {
    const double hard = std::max(0.0, after - kHardens) / (0.2 - kHardens);
    add(kUpper + after, flow(after) + 120e6 * (2.0 - hard) * hard);
  }
  return curve;
}

// Down to 325 MPa, back within some hundredths of a per cent, then a plateau at 350 MPa.
TEST(Characteristics, TheLowerYieldStrengthLeavesOutTheInitialTransient) {
  for (const double noise : {0.0, 0.5e6}) {
    for (const double length : {3e-4, 6e-4, 1.2e-3}) {
      const auto dip = [&](double after) {
        if (after < 0.3 * length) return 400e6 - 75e6 * after / (0.3 * length);
        return after < length ? 325e6 + 25e6 * (after / length - 0.3) / 0.7 : 350e6;
      };
      const Characteristics c = make_target("dip", with_flow(dip, noise)).characteristics;
      EXPECT_NEAR(c.reh.value(), 400e6, 4.0 * noise + 1.0);
      // The least of 150 samples of a plateau with noise; a twentieth of the depth.
      EXPECT_GT(c.rel.value(), 350e6 - 4.0 * noise - 0.05 * 25e6) << noise << " " << length;
      EXPECT_LT(c.rel.value(), 350e6 + 1.0);
    }
  }
}

TEST(Characteristics, TheLowerYieldStrengthIsTheLeastWhereThereIsNoTransient) {
  const auto plateau = [](double after) { return after < 4e-4 ? 370e6 : 350e6; };
  const auto hardens = [](double after) {
    return after < 4e-4 ? 400e6 - 60e6 * after / 4e-4
                        : 340e6 + 60e6 * std::pow((after - 4e-4) / 0.015, 0.3);
  };
  const auto slowly = [](double after) {
    return after < 1e-3 ? 400e6 - 75e6 * after / 1e-3
                        : std::min(350e6, 325e6 + 25e6 * (after - 1e-3) / 4e-3);
  };
  const auto falls = [](double after) { return after < 4e-4 ? 360e6 : 350e6 - 400e6 * after; };
  const auto shallow = [](double after) {
    return after < 3e-4 ? 370e6 : after < 6e-4 ? 349.5e6 : 350e6;
  };
  for (const double noise : {0.0, 0.5e6}) {
    const auto rel = [&](const auto& flow, double least) {
      const Characteristics c = make_target("least", with_flow(flow, noise)).characteristics;
      ASSERT_TRUE(c.rel.has_value());
      EXPECT_NEAR(*c.rel, least, 4.0 * noise + 1.0);
    };
    rel(plateau, 350e6);
    rel(hardens, 340e6);
    rel(slowly, 325e6);
    rel(falls, 350e6 - 400e6 * 0.015);
    rel(shallow, 349.5e6);
  }
}

TEST(Characteristics, AStressThatRelaxesInAPauseIsNoYieldPoint) {
  Curve curve = smooth_curve(2000);
  const std::size_t at = 150;
  const double strain = curve.strain[at];
  const double stress = curve.stress[at];
  for (std::size_t i = 1; i <= 20; ++i) {
    const auto place = static_cast<std::ptrdiff_t>(at + i);
    curve.strain.insert(curve.strain.begin() + place, strain + 1e-9 * static_cast<double>(i));
    curve.stress.insert(curve.stress.begin() + place,
                        stress * (1.0 - 0.002 * static_cast<double>(i)));
  }
  const Target target = make_target("pause", curve);
  EXPECT_FALSE(target.characteristics.reh);
  EXPECT_TRUE(std::ranges::any_of(target.warnings, [](const std::string& warning) {
    return warning.find("while the strain stands still: a pause") != std::string::npos;
  }));
}

TEST(Characteristics, ADropWithinTheNoiseIsNoYieldPoint) {
  const std::vector<double> stress{0.0, 100.0, 200.0, 300.0, 294.0, 295.0, 350.0};
  EXPECT_TRUE(find_yield_point(stress, 0.5, 0.003).has_value());
  EXPECT_FALSE(find_yield_point(stress, 0.5, 0.003)->later_peak.has_value());
  EXPECT_FALSE(find_yield_point(stress, 1.0, 0.003).has_value());
}

/// A load cell's steps are noise wherever the curve is not steep, though it stands still between
/// them: a fall by one is no yield point.
TEST(Characteristics, AStepOfACoarseLoadCellIsNoYieldPoint) {
  int called = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 0.5e6);
    Curve curve = smooth_curve(220, 0.06);
    for (double& stress : curve.stress) stress = 2e6 * std::round((stress + normal(random)) / 2e6);
    called += make_target("coarse", curve).characteristics.reh ? 1 : 0;
  }
  EXPECT_EQ(called, 0);
}

/// What is clipped at a load cell's limit says nothing of the noise before it.
TEST(Characteristics, NoiseIsThatOfWhatMoves) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0.0, 2e6);
  Curve curve = smooth_curve(400, 0.06);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve.stress[i] = i < 240 ? curve.stress[i] + normal(random) : curve.stress[239];
  }
  EXPECT_NEAR(noise_of(curve.strain, curve.stress), 2e6, 0.3e6);
}

TEST(Characteristics, TheBreakStrainIsTheMiddleOfItsIntervalTotalAndPermanent) {
  IdealPlastic test;
  test.plateau = 99;
  const Characteristics c = make_target("break", test.curve()).characteristics;
  const double step = test.permanent_break / 99.5;
  EXPECT_NEAR(c.break_strain_plastic.value(), test.permanent_break, 1e-12);
  EXPECT_NEAR(c.break_strain.value(), test.permanent_break + test.yield_strain(), 1e-12);
  EXPECT_NEAR(c.observed_break->half_interval(), 0.5 * step, 1e-12);
  EXPECT_NEAR(c.largest_strain, test.yield_strain() + 99.0 * step, 1e-12);
}

TEST(Characteristics, ACyclicCurveThatStartsInCompressionHasAModulus) {
  Curve curve;
  for (int i = 0; i <= 400; ++i) {
    const double strain = -0.004 * std::sin(0.0314159265 * i);
    curve.strain.push_back(strain);
    curve.stress.push_back(70e9 * strain);
  }
  const Target target = make_target("compression first", curve);
  EXPECT_EQ(target.loading, Loading::Cyclic);
  EXPECT_NEAR(target.characteristics.youngs_modulus.value(), 70e9, 1e3);
}

/// Of bars that are elastic until they break: the mean of what is measured is none, and its errors
/// are those of the modulus, too.
TEST(Characteristics, OfElasticBarsHaveNoPermanentStrainInTheMean) {
  constexpr int kBars = 60;
  const plastica::testing::IdealPlastic brittle{.modulus = 200e9,
                                                .yield_stress = 900e6,
                                                .permanent_break = 5e-6,
                                                .elastic = 99,
                                                .plateau = 0,
                                                .broken = 1,
                                                .noise = 1.0 / 300.0};
  double sum = 0.0, squares = 0.0, counted = 0.0;
  for (unsigned seed = 1; seed <= kBars; ++seed) {
    const Characteristics c = make_target("bar", brittle.curve(seed)).characteristics;
    if (!c.break_strain_plastic) continue;
    const double error = c.permanent_strain_error();
    EXPECT_GT(error, c.observed_break->half_interval());
    sum += *c.break_strain_plastic;
    squares += std::pow(*c.break_strain_plastic / error, 2);
    counted += 1.0;
  }
  EXPECT_GE(counted, 0.9 * kBars);
  // 5e-6, half the last step, is how the break's middle lies above the last sample.
  EXPECT_NEAR(sum / counted, 5e-6, 2e-5);
  EXPECT_LT(squares / counted, 2.0);
}

}  // namespace
}  // namespace plastica::calibrate
