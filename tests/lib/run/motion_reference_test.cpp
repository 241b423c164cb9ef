#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plastica/solve/scheme.hpp"
#include "plastica/theory/beam_vibration.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/released_cantilever.hpp"
#include "tests/support/tolerance.hpp"

/// A soft cantilever that falls and swings, against the history of a finely divided chain.
///
/// That chain has the rotary inertia of its section: with it on, ours tends to the table with order
/// two in the number of segments (2.077, 0.521, 0.131, 0.033, 0.008 % at N = 16 … 256); with it
/// off, to a beam that swings faster by 8e-5 and so is 0.10 % away after a second.
namespace plastica {
namespace {

using testing::tolerance;
using theory::BeamEnds;

constexpr double kSag = 0.022063903;  ///< static, geometrically exact [m]
constexpr int kSamples = 1000;        ///< a millisecond apart

/// Way of the tip down at each millisecond, 0 … 999.
std::vector<double> tip_history(int segments, Scheme scheme, double time_step,
                                RotaryInertia rotary) {
  SolverOptions options = testing::in_motion(scheme, 1.0, time_step, kSamples);
  options.rotary_inertia = rotary;
  const Response response = testing::completed(testing::released_cantilever(segments), options);
  std::vector<double> tip;
  for (int k = 0; k < kSamples; ++k)
    tip.push_back(-response.probes[0][static_cast<std::size_t>(k)]);
  return tip;
}

std::vector<double> reference_history() {
  const testing::ReferenceTable table("w1-cantilever-history/tip.csv");
  EXPECT_EQ(table.rows(), static_cast<std::size_t>(kSamples));
  std::vector<double> tip;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    EXPECT_NEAR(table.at("t_s", i), 1e-3 * static_cast<double>(i), 1e-12);
    tip.push_back(table.at("tip_deflection_m", i));
  }
  return tip;
}

/// Of the tip's history, over the static sag.
double error_of(int segments, Scheme scheme, double time_step) {
  const auto tip = tip_history(segments, scheme, time_step, RotaryInertia::On);
  return testing::rms_between(tip, reference_history()) / kSag;
}

TEST(MotionReference, ErrsByTheKnownFractionsOfEverFinerChains) {
  // What peers with the same half joint reach at small steps: 2.1, 0.51 and 0.12 %.
  const double known[3] = {0.021, 0.0051, 0.0012};
  for (int k = 0; k < 3; ++k) {
    const double step = k < 2 ? 1e-4 : 5e-5;
    const double error = error_of(16 << k, Scheme::LinearlyImplicitMidpoint, step);
    EXPECT_NEAR(error / known[k], 1.0, tolerance(0.1)) << (16 << k);
  }
}

TEST(MotionReference, IsMetToHalfAPercentAtAMillisecondByEverySchemeOfOrderTwo) {
  int schemes = 0;
  for (const Scheme scheme : {Scheme::LinearlyImplicitEuler, Scheme::LinearlyImplicitMidpoint,
                              Scheme::GeneralizedAlpha, Scheme::EnergyMomentum}) {
    if (solve::claims_of(scheme, SolverOptions{}.rho_infinity).order != 2) continue;
    ++schemes;
    EXPECT_LE(error_of(64, scheme, 1e-3), tolerance(0.005)) << static_cast<int>(scheme);
  }
  EXPECT_EQ(schemes, 3);
}

TEST(MotionReference, LosesWithRotaryInertiaTheTimeThatRayleighsBeamLoses) {
  const auto history = [](RotaryInertia rotary) {
    return tip_history(64, Scheme::LinearlyImplicitMidpoint, 2.5e-4, rotary);
  };
  const auto with = history(RotaryInertia::On);
  const auto without = history(RotaryInertia::Off);

  const Scene scene = testing::released_cantilever(64);
  const SectionProperties section = testing::properties_of(scene);
  const theory::VibratingBeam beam{
      .bending_stiffness = testing::bending_stiffness_of(scene),
      .mass_per_length = scene.material.density * section.area,
      .rotary_inertia = scene.material.density * section.second_moment_x};
  // Mode by mode, a fraction of the sag that swings as fast as Euler's beam or as Rayleigh's.
  constexpr int kModes = 5;
  const auto tip_of_mode = [&](int mode, double time) {
    const double others = mode == 1 ? 0.0 : released_cantilever_tip(beam, 9.81, time, mode - 1);
    return released_cantilever_tip(beam, 9.81, time, mode) - others;
  };
  std::vector<double> euler(kSamples), rayleigh(kSamples);
  for (int mode = 1; mode <= kModes; ++mode) {
    const double slower = theory::rayleigh_cantilever_frequency(mode, beam) /
                          circular_frequency(BeamEnds::ClampedFree, mode, beam);
    for (std::size_t k = 0; k < euler.size(); ++k) {
      const double time = 1e-3 * static_cast<double>(k);
      euler[k] += tip_of_mode(mode, time);
      rayleigh[k] += tip_of_mode(mode, slower * time);
    }
  }
  const double expected = testing::rms_between(euler, rayleigh);
  EXPECT_NEAR(expected / kSag, 0.0010, 5e-5);
  EXPECT_NEAR(testing::rms_between(with, without) / expected, 1.0, tolerance(0.005));
}

}  // namespace
}  // namespace plastica
