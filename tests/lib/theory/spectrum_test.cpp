#include "plastica/theory/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/tolerance.hpp"

namespace plastica::theory {
namespace {

using plastica::testing::tolerance;

struct Sine {
  double frequency;  ///< [Hz]
  double amplitude;
  double phase = 0.0;  ///< [rad]
};

std::vector<double> history(const std::vector<Sine>& sines, std::size_t samples, double time_step,
                            double mean = 0.0) {
  std::vector<double> values(samples, mean);
  for (std::size_t k = 0; k < samples; ++k) {
    const double time = static_cast<double>(k) * time_step;
    for (const Sine& sine : sines) {
      values[k] +=
          sine.amplitude * std::sin(2.0 * std::numbers::pi * sine.frequency * time + sine.phase);
    }
  }
  return values;
}

std::vector<SpectralPeak> peaks_of(const std::vector<double>& values, double time_step,
                                   double floor = 1e-3) {
  return spectral_peaks(amplitude_spectrum(values, time_step), floor);
}

/// What the parabola and the sine's image below zero leave of the frequency of a lone sine [1/T].
double frequency_bound(double periods) {
  const double a = std::numbers::pi * std::numbers::pi / 6.0 - 1.0;
  const double image = 2.0 * periods;
  // The slope of the image's side lobes, cos(pi D)/(D (1 - D^2)) and the sine's part.
  const double rest = (3.0 * image * image - 1.0) / (std::numbers::pi * image * image);
  const double slope =
      std::hypot(1.0, rest * image / (image * image - 1.0)) / (image * (image * image - 1.0));
  return 2e-4 + slope / (2.0 * a);
}

TEST(Spectrum, FindsALoneSineWithinTheDerivedBoundWhereverItLiesBetweenTheBins) {
  constexpr std::size_t kSamples = 1000;
  constexpr double kStep = 1e-3;
  const double duration = kSamples * kStep;
  for (const double periods : {3.0, 5.0, 20.0, 100.0}) {
    for (int part = 0; part < 8; ++part) {
      for (const double phase : {0.0, 0.7, 1.5, 2.6}) {
        const double frequency = (periods + part / 8.0) / duration;
        const auto peaks = peaks_of(history({{frequency, 2.0, phase}}, kSamples, kStep), kStep);
        ASSERT_EQ(peaks.size(), 1U) << periods << ' ' << part << ' ' << phase;
        const double bound = frequency_bound(periods);
        EXPECT_NEAR(peaks[0].frequency * duration, frequency * duration, tolerance(bound));
        // The amplitude is off by what the image adds, 1/(pi D^3), and the parabola by 1e-4.
        EXPECT_NEAR(peaks[0].amplitude / 2.0, 1.0,
                    tolerance(2e-4 + 0.32 / std::pow(2.0 * periods - 1.0, 3)));
      }
    }
  }
}

TEST(Spectrum, SortsSinesByAmplitudeDownToTheFloor) {
  constexpr double kStep = 1e-3;
  const auto values =
      history({{20.3, 1.0}, {127.1, 0.3, 1.0}, {56.6, 0.02, 2.0}, {391.0, 0.004}}, 1024, kStep);
  const auto peaks = peaks_of(values, kStep);
  ASSERT_EQ(peaks.size(), 4U);
  const double resolution = 1.0 / 1.024;
  EXPECT_NEAR(peaks[0].frequency, 20.3, tolerance(1e-3 * resolution));
  EXPECT_NEAR(peaks[1].frequency, 127.1, tolerance(1e-3 * resolution));
  EXPECT_NEAR(peaks[2].frequency, 56.6, tolerance(1e-2 * resolution));
  EXPECT_NEAR(peaks[3].frequency, 391.0, tolerance(1e-2 * resolution));
  EXPECT_NEAR(peaks[1].amplitude, 0.3, tolerance(3e-4));
  EXPECT_NEAR(peaks[2].amplitude, 0.02, tolerance(2e-4));
  EXPECT_EQ(peaks_of(values, kStep, 0.1).size(), 2U);
  EXPECT_EQ(peaks_of(values, kStep, 1.0).size(), 1U);
}

TEST(Spectrum, TellsTwoSinesApartFromThreeBinsOn) {
  constexpr double kStep = 1e-2;
  constexpr std::size_t kSamples = 1000;
  const double duration = kSamples * kStep;
  const auto two = [&](double distance) {
    const double first = 100.0 / duration;
    return peaks_of(
        history({{first, 1.0}, {first + distance / duration, 1.0, 0.4}}, kSamples, kStep), kStep);
  };
  for (const double distance : {3.0, 3.5, 4.0, 8.0}) {
    const auto peaks = two(distance);
    ASSERT_EQ(peaks.size(), 2U) << distance;
    const double low = std::min(peaks[0].frequency, peaks[1].frequency) * duration;
    const double high = std::max(peaks[0].frequency, peaks[1].frequency) * duration;
    EXPECT_NEAR(low, 100.0, tolerance(frequency_bound(0.5 * distance)));
    EXPECT_NEAR(high, 100.0 + distance, tolerance(frequency_bound(0.5 * distance)));
  }
}

TEST(Spectrum, TakesTheMeanOff) {
  constexpr double kStep = 1e-3;
  const auto plain = peaks_of(history({{40.4, 1e-3}}, 500, kStep), kStep);
  const auto lifted = peaks_of(history({{40.4, 1e-3}}, 500, kStep, 50.0), kStep);
  ASSERT_EQ(lifted.size(), 1U);
  EXPECT_NEAR(lifted[0].frequency, plain[0].frequency, tolerance(1e-8));
  EXPECT_NEAR(lifted[0].amplitude / plain[0].amplitude, 1.0, tolerance(1e-8));
}

TEST(Spectrum, OfASineInNoiseIsTheSineAlone) {
  constexpr double kStep = 1e-3;
  constexpr std::size_t kSamples = 1024;
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    auto values = history({{100.0 + trial * 1.37, 1.0, 0.3 * trial}}, kSamples, kStep);
    for (double& value : values) value += noise(random);
    const auto peaks = peaks_of(values, kStep);
    ASSERT_EQ(peaks.size(), 1U) << trial;
    // Cramer and Rao: sqrt(24) s/(A 2 pi sqrt(n)) = 0.024 bins for s = A; twice that with a Hann
    // window, and four of these.
    EXPECT_NEAR(peaks[0].frequency, 100.0 + trial * 1.37, tolerance(0.2 / (kSamples * kStep)));
  }
}

TEST(Spectrum, OfNoiseAloneHasNoPeaks) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0.0, 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<double> values(2000);
    for (double& value : values) value = noise(random);
    EXPECT_TRUE(peaks_of(values, 1.0).empty()) << trial;
  }
}

TEST(Spectrum, HasItsAmplitudesAtTheBinsOfTheSines) {
  // Whole periods: the bin of the sine holds it, its neighbours at 1/T half of it, and those from
  // 2/T on nothing.
  const Spectrum spectrum = amplitude_spectrum(history({{8.0, 3.0}}, 64, 1.0 / 64.0), 1.0 / 64.0);
  EXPECT_EQ(spectrum.duration, 1.0);
  ASSERT_EQ(spectrum.frequency.size(), 129U);
  EXPECT_EQ(spectrum.frequency.back(), 32.0);
  EXPECT_EQ(spectrum.frequency[32], 8.0);
  EXPECT_NEAR(spectrum.amplitude[32], 3.0, tolerance(1e-12));
  EXPECT_NEAR(spectrum.amplitude[36], 1.5, tolerance(1e-12));
  EXPECT_NEAR(spectrum.amplitude[40], 0.0, tolerance(1e-12));
  EXPECT_NEAR(spectrum.amplitude[0], 0.0, tolerance(1e-12));
}

TEST(Spectrum, OfTooShortOrTooSlowAHistoryHasNoPeaks) {
  EXPECT_TRUE(amplitude_spectrum(std::vector<double>(15, 1.0), 0.1).frequency.empty());
  EXPECT_TRUE(peaks_of({}, 0.1).empty());
  EXPECT_TRUE(peaks_of(std::vector<double>(100, 1.0), 0.1).empty()) << "at rest";
  for (const double phase : {0.0, 0.7, 1.5, 2.6}) {
    for (const double periods : {0.3, 0.5, 1.0, 1.5, 1.75}) {
      EXPECT_TRUE(peaks_of(history({{0.1 * periods, 1.0, phase}}, 100, 0.1), 0.1).empty())
          << periods << ' ' << phase;
    }
  }
}

TEST(Spectrum, OfABeamThatFliesAwayIsWhatItVibratesWith) {
  constexpr double kStep = 1e-3;
  std::vector<double> values = history({{61.7, 1e-3}}, 2000, kStep);
  const auto still = [&](std::size_t k) {
    const double time = static_cast<double>(k) * kStep;
    return 3.0 * time - 0.5 * 9.81 * time * time;
  };
  std::vector<double> smooth(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    smooth[k] = still(k);
    values[k] += smooth[k];
  }
  EXPECT_TRUE(peaks_of(smooth, kStep).empty()) << "not even of round-off";
  const auto peaks = peaks_of(values, kStep);
  ASSERT_EQ(peaks.size(), 1U);
  // The fall of some 3 m leaks 4.3 x 3 m/(pi D^3) = 2.2e-6 m to D = 123, and moves the peak by
  // pi x 0.0022/(2 a) of 1/T.
  EXPECT_NEAR(peaks[0].frequency, 61.7, tolerance(5e-3 / 2.0));
  EXPECT_NEAR(peaks[0].amplitude, 1e-3, tolerance(2.5e-6));
}

TEST(Spectrum, OfATransientHasNoPeaksWhereItRipples) {
  // A weight that is laid down: to its place within a twentieth of the history, without swinging.
  std::vector<double> values(500);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double time = static_cast<double>(k) / 500.0;
    values[k] = 0.5 * (std::exp(-60.0 * time) * (1.0 + 60.0 * time) - 1.0);
  }
  EXPECT_TRUE(peaks_of(values, 1.0 / 500.0).empty());
}

TEST(Spectrum, OfASineThatDiesSoonIsStillAPeak) {
  constexpr double kStep = 1e-3;
  std::vector<double> values = history({{80.0, 1.0}}, 1000, kStep);
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] *= std::exp(-12.0 * static_cast<double>(k) * kStep);
  }
  const auto peaks = peaks_of(values, kStep);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].frequency, 80.0, tolerance(0.1));
}

TEST(Spectrum, OfADecayingSineIsAtItsFrequency) {
  constexpr double kStep = 1e-3;
  std::vector<double> values = history({{50.3, 1.0}}, 1000, kStep);
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] *= std::exp(-3.0 * static_cast<double>(k) * kStep);
  }
  const auto peaks = peaks_of(values, kStep);
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].frequency, 50.3, tolerance(1e-3));
}

}  // namespace
}  // namespace plastica::theory
