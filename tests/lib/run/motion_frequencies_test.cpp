#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "plastica/run/natural_frequencies.hpp"
#include "plastica/solve/scheme.hpp"
#include "plastica/theory/spectrum.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Frequencies of chains by stepping through time.
namespace plastica {
namespace {

using testing::tolerance;

struct Stepped {
  const char* name;
  Scheme scheme;
  EndRule rule;
};

class SteppedFrequencies : public ::testing::TestWithParam<Stepped> {};

/// A steel cantilever of 32 joints (31 where it is clamped) whose outer half is struck so gently
/// that its rotations stay below 1e-3: its first modes swing.
Scene struck_gently(EndRule rule) {
  Scene scene = testing::cantilever_scene(rule == EndRule::Half ? 33 : 32);
  scene.end_rule = rule;
  InitialMotion blow;
  blow.from = {0.5, {}};
  blow.velocity = {0.0, 0.01, 0.0};
  scene.initial_motions = {blow};
  testing::add_probe(scene, ProbeQuantity::Velocity, Place::end(), Component::Y);
  return scene;
}

TEST_P(SteppedFrequencies, AreThoseOfTheEigenvalueProblemAtFourHundredStepsAPeriod) {
  constexpr int kPeriods = 8;
  const Scene scene = struck_gently(GetParam().rule);
  SolverOptions options;
  options.analysis = Analysis::Dynamics;
  options.duration = 1.0;
  options.rotary_inertia = RotaryInertia::Off;
  const auto exact = natural_frequencies(scene, options, 3).frequency;
  options = testing::motion_options(GetParam().scheme, 1.0 / (400.0 * exact[0]), 400 * kPeriods);
  options.rotary_inertia = RotaryInertia::Off;
  const Response response = testing::completed(scene, options);
  auto peaks = theory::spectral_peaks(
      theory::amplitude_spectrum(response.probes[0], options.time_step), 1e-2);
  std::sort(peaks.begin(), peaks.end(),
            [](const auto& a, const auto& b) { return a.frequency < b.frequency; });
  // A scheme of first order damps omega by omega^2 h/2: after a period of the first mode the others
  // are gone.
  const std::size_t modes = solve::claims_of(GetParam().scheme, 0.8).order == 1 ? 1 : 3;
  ASSERT_GE(peaks.size(), modes);
  for (std::size_t k = 0; k < modes; ++k) {
    EXPECT_NEAR(peaks[k].frequency / exact[k], 1.0, tolerance(0.01)) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, SteppedFrequencies,
    ::testing::Values(
        Stepped{"ClampedEuler", Scheme::LinearlyImplicitEuler, EndRule::Equal},
        Stepped{"ClampedMidpoint", Scheme::LinearlyImplicitMidpoint, EndRule::Equal},
        Stepped{"HalfJointEuler", Scheme::LinearlyImplicitEuler, EndRule::HalfJoint},
        Stepped{"HalfJointMidpoint", Scheme::LinearlyImplicitMidpoint, EndRule::HalfJoint},
        Stepped{"HalfJointAlpha", Scheme::GeneralizedAlpha, EndRule::HalfJoint},
        Stepped{"HalfJointEnergyMomentum", Scheme::EnergyMomentum, EndRule::HalfJoint},
        Stepped{"HalfEndsMidpoint", Scheme::LinearlyImplicitMidpoint, EndRule::Half}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace plastica
