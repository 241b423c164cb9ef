#include "plastica/theory/beam_vibration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/reference/reference_table.hpp"
#include "tests/support/tolerance.hpp"

namespace plastica::theory {
namespace {

using std::numbers::pi;
using testing::tolerance;

TEST(BeamFrequencies, RootsMatchTheReferenceTable) {
  const testing::ReferenceTable table("cantilever-frequencies/beta_L.csv");
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const int mode = static_cast<int>(table.at("mode", i));
    SCOPED_TRACE(mode);
    EXPECT_NEAR(frequency_root(BeamEnds::ClampedFree, mode), table.at("clamped_free", i), 1e-13);
    EXPECT_NEAR(frequency_root(BeamEnds::FreeFree, mode),
                table.at("free_free_and_clamped_clamped", i), 1e-13);
    EXPECT_NEAR(frequency_root(BeamEnds::ClampedPinned, mode), table.at("clamped_pinned", i),
                1e-13);
    EXPECT_NEAR(frequency_root(BeamEnds::PinnedPinned, mode), table.at("pinned_pinned", i), 1e-13);
  }
}

TEST(BeamFrequencies, HighModesTendToTheirAsymptoteWithoutOverflow) {
  EXPECT_NEAR(frequency_root(BeamEnds::ClampedFree, 1000), 999.5 * pi, 1e-9);
  EXPECT_NEAR(frequency_root(BeamEnds::ClampedPinned, 1000), 1000.25 * pi, 1e-9);
}

TEST(BeamFrequencies, FirstOfASteelRulerIsAboutFortyHertz) {
  // b x h = 30 x 1 mm, L = 145 mm: (1.8751^2/2 pi) sqrt(E/(12 rho)) h/L^2.
  const VibratingBeam ruler{.length = 0.145,
                            .bending_stiffness = 210e9 * 0.03 * 1e-9 / 12.0,
                            .mass_per_length = 7850.0 * 0.03 * 1e-3};
  const double hertz = circular_frequency(BeamEnds::ClampedFree, 1, ruler) / (2.0 * pi);
  EXPECT_NEAR(hertz, 0.55959 * std::sqrt(210e9 / (12.0 * 7850.0)) * 1e-3 / (0.145 * 0.145), 1e-3);
}

/// What is left at the free end of a cantilever of unit length, stiffness and mass that swings with
/// omega^2 = b: the determinant of (moment, shear force) of the two motions that the clamp allows,
/// by Runge and Kutta's method, over its size.
double unmet_end(double b, double gyration) {
  using State = std::array<double, 4>;  // W, W', W'', W'''
  const auto slope = [&](const State& w) {
    return State{w[1], w[2], w[3], b * w[0] - b * gyration * w[2]};
  };
  const auto ahead = [](const State& w, double h, const State& k) {
    State moved = w;
    for (std::size_t i = 0; i < 4; ++i) moved[i] += h * k[i];
    return moved;
  };
  std::array<std::array<double, 2>, 2> end{};
  for (std::size_t motion = 0; motion < 2; ++motion) {
    State w{};
    w[2 + motion] = 1.0;
    constexpr int kSteps = 2000;
    constexpr double kStep = 1.0 / kSteps;
    for (int n = 0; n < kSteps; ++n) {
      const State k1 = slope(w);
      const State k2 = slope(ahead(w, 0.5 * kStep, k1));
      const State k3 = slope(ahead(w, 0.5 * kStep, k2));
      const State k4 = slope(ahead(w, kStep, k3));
      for (std::size_t i = 0; i < 4; ++i) {
        w[i] += kStep / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
      }
    }
    end[motion] = {w[2], w[3] + b * gyration * w[1]};
  }
  const double one = end[0][0] * end[1][1];
  const double other = end[0][1] * end[1][0];
  return (one - other) / (std::abs(one) + std::abs(other));
}

/// The first roots b of `unmet_end`, found by their changes of sign alone, to 1e-11 of b. Each root
/// is at least two and a half times the one before.
std::vector<double> integrated_roots(double gyration, std::size_t count) {
  std::vector<double> roots;
  double low = 1.0;
  bool above = unmet_end(low, gyration) > 0.0;  // at `low`
  while (roots.size() < count) {
    double high = low * 1.1;
    const double next = high;
    const bool above_next = unmet_end(next, gyration) > 0.0;
    if (above != above_next) {
      for (int k = 0; k < 34; ++k) {
        const double middle = 0.5 * (low + high);
        ((unmet_end(middle, gyration) > 0.0) != above ? high : low) = middle;
      }
      roots.push_back(high);
    }
    low = next;
    above = above_next;
  }
  return roots;
}

TEST(RayleighCantilever, HasTheFrequenciesOfItsEquationOfMotion) {
  for (const double gyration : {1e-4, 1e-3, 1e-2}) {
    const VibratingBeam beam{.rotary_inertia = gyration};
    const std::vector<double> roots = integrated_roots(gyration, 4);
    for (int mode = 1; mode <= 4; ++mode) {
      const double omega = rayleigh_cantilever_frequency(mode, beam);
      EXPECT_NEAR(omega / std::sqrt(roots[static_cast<std::size_t>(mode - 1)]), 1.0,
                  tolerance(1e-8))
          << gyration << " " << mode;
    }
  }
}

TEST(RayleighCantilever, IsEulersWithoutRotaryInertia) {
  const VibratingBeam beam{.length = 2.5, .bending_stiffness = 7.0, .mass_per_length = 0.3};
  for (const int mode : {1, 2, 3, 10, 100}) {
    EXPECT_NEAR(rayleigh_cantilever_frequency(mode, beam) /
                    circular_frequency(BeamEnds::ClampedFree, mode, beam),
                1.0, tolerance(1e-13))
        << mode;
  }
}

TEST(RayleighCantilever, FallsAtFirstByTheModesFractionOfRotation) {
  // Rayleigh's quotient: omega^2 falls by r^2 int W'^2/int W^2, of the cantilever's modes
  // s x (2 + s x) with x = beta L and s = (cosh x + cos x)/(sinh x + sin x).
  const double gyration = 1e-8;
  for (const int mode : {1, 2, 3}) {
    const double x = frequency_root(BeamEnds::ClampedFree, mode);
    const double s = (std::cosh(x) + std::cos(x)) / (std::sinh(x) + std::sin(x));
    const double ratio =
        rayleigh_cantilever_frequency(mode, {.rotary_inertia = gyration}) / (x * x);
    EXPECT_NEAR((1.0 - ratio) / (0.5 * gyration * s * x * (2.0 + s * x)), 1.0, 1e-5) << mode;
  }
}

TEST(TorsionFrequencies, AreTheOddQuartersOfTheWaveSpeed) {
  // A wave that runs four times along the bar in one period, with sqrt(G J/(rho I_p)) = 2 m/s.
  EXPECT_NEAR(clamped_free_torsion_frequency(1, 0.5, 8.0, 2.0), 2.0 * pi, 1e-14);
  EXPECT_NEAR(clamped_free_torsion_frequency(3, 0.5, 8.0, 2.0), 10.0 * pi, 1e-13);
}

/// The beam of w1-cantilever-history.
VibratingBeam w1_beam() {
  return {.length = 1.0,
          .bending_stiffness = 2e9 * std::pow(0.02, 4) / 12.0,
          .mass_per_length = 1200.0 * 0.02 * 0.02};
}

TEST(ReleasedCantilever, FallsFreelyAtFirst) {
  const double time = 2e-4;  // until the bending that comes from the clamp has reached the tip
  const double tip = released_cantilever_tip(w1_beam(), 9.81, time, 400);
  EXPECT_NEAR(tip / (0.5 * 9.81 * time * time), 1.0, 1e-3);
}

TEST(ReleasedCantilever, SwingsAboutItsStaticSag) {
  const VibratingBeam beam = w1_beam();
  const double period = 2.0 * pi / circular_frequency(BeamEnds::ClampedFree, 1, beam);
  double sum = 0.0;
  constexpr int kPeriods = 200, kSamples = 40 * kPeriods;
  for (int k = 0; k < kSamples; ++k) {
    sum += released_cantilever_tip(beam, 9.81, (k + 0.5) * kPeriods * period / kSamples, 8);
  }
  const double sag = 9.81 * beam.mass_per_length / (8.0 * beam.bending_stiffness);
  EXPECT_NEAR(sum / kSamples / sag, 1.0, 1e-4);
}

TEST(ReleasedCantilever, LeavesTheGeometricallyExactHistoryByItsStatedDifference) {
  const testing::ReferenceTable table("w1-cantilever-history/tip.csv");
  ASSERT_EQ(table.rows(), 1000U);
  double sum = 0.0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double linear = released_cantilever_tip(w1_beam(), 9.81, table.at("t_s", i), 15);
    const double off = linear - table.at("tip_deflection_m", i);
    sum += off * off;
  }
  const double rms = std::sqrt(sum / static_cast<double>(table.rows()));
  EXPECT_NEAR(rms / 0.022063903, 0.0026, 5e-5);
}

}  // namespace
}  // namespace plastica::theory
