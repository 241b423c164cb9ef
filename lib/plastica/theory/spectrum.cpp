#include "plastica/theory/spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include <unsupported/Eigen/FFT>

namespace plastica::theory {
namespace {

constexpr double kQuartiles = 8.0;   ///< lower quartiles of all bins that a peak is above
constexpr double kProminence = 2.0;  ///< of a peak over the dips beside it
constexpr double kLeak = 2.0;        ///< envelopes of each larger sine that a peak is above
/// The same of what is slower than 2/T: the mean that is taken off lowers its own peak. Measured
/// up to 4.9 of ramps and parabolas, 9.9 of a parabola about the middle, 16.2 of a cubic about it.
constexpr double kSlowLeak = 20.0;
constexpr double kRoundOff = 1e-10;       ///< of the largest amplitude
constexpr double kFirstSideLobe = 2.362;  ///< its distance [1/T] …
constexpr double kSideLobe = 0.02671;     ///< … and height: the largest of all

double hann(std::size_t k, std::size_t n) {
  const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
  return 0.5 * (1.0 - std::cos(turn));
}

/// What a sine of amplitude 1 reaches at most at a distance of d/T or beyond.
double envelope(double d) {
  constexpr double kPi = std::numbers::pi;
  if (d >= kFirstSideLobe) return std::min(kSideLobe, 1.0 / (kPi * d * (d * d - 1.0)));
  if (d < 1e-6) return 1.0;
  if (std::fabs(d - 1.0) < 1e-6) return 0.5;
  return std::max(kSideLobe, std::sin(kPi * d) / (kPi * d * (1.0 - d * d)));
}

double lower_quartile(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Whether a bin falls to its part `kProminence` on both sides before there is a higher one. Both
/// sides are searched together, so that a ripple of a long slope is found out by its near side.
bool stands_out(const std::vector<double>& amplitude, std::size_t bin) {
  const double low = amplitude[bin] / kProminence;
  std::size_t left = bin;
  std::size_t right = bin;
  while (amplitude[left] > low || amplitude[right] > low) {
    if (amplitude[left] > low && (left == 0 || amplitude[--left] > amplitude[bin])) return false;
    if (amplitude[right] > low &&
        (right + 1 == amplitude.size() || amplitude[++right] > amplitude[bin])) {
      return false;
    }
  }
  return true;
}

/// The vertex of the parabola through the logarithms of three bins, the middle one the largest.
SpectralPeak vertex(const Spectrum& spectrum, std::size_t bin) {
  const double left = std::log(spectrum.amplitude[bin - 1]);
  const double middle = std::log(spectrum.amplitude[bin]);
  const double right = std::log(spectrum.amplitude[bin + 1]);
  const double width = spectrum.frequency[1];
  const double curvature = left - 2.0 * middle + right;
  // A neighbour of nothing, or three alike.
  if (!(curvature < 0.0) || !std::isfinite(curvature)) {
    return {spectrum.frequency[bin], spectrum.amplitude[bin]};
  }
  const double shift = 0.5 * (left - right) / curvature;
  return {spectrum.frequency[bin] + shift * width,
          std::exp(middle - 0.25 * (left - right) * shift)};
}

}  // namespace

Spectrum amplitude_spectrum(std::span<const double> values, double time_step) {
  const std::size_t n = values.size();
  Spectrum spectrum;
  spectrum.duration = static_cast<double>(n) * time_step;
  if (n < kFewestSamples) return spectrum;
  double weight = 0.0;
  double mean = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    weight += hann(k, n);
    mean += hann(k, n) * values[k];
  }
  mean /= weight;
  const std::size_t padded = std::bit_ceil(4 * n);
  std::vector<double> windowed(padded, 0.0);
  for (std::size_t k = 0; k < n; ++k) windowed[k] = hann(k, n) * (values[k] - mean);
  Eigen::FFT<double> transform;
  transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<std::complex<double>> bins;
  transform.fwd(bins, windowed);
  const double width = 1.0 / (static_cast<double>(padded) * time_step);
  for (std::size_t k = 0; k < bins.size(); ++k) {
    // A sine is half at its frequency and half at its image, but where both are the same bin.
    const double fraction = k == 0 || k + 1 == bins.size() ? 1.0 : 2.0;
    spectrum.frequency.push_back(static_cast<double>(k) * width);
    spectrum.amplitude.push_back(fraction * std::abs(bins[k]) / weight);
  }
  return spectrum;
}

std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, double floor) {
  const std::vector<double>& amplitude = spectrum.amplitude;
  std::vector<SpectralPeak> found;
  if (amplitude.size() < 3) return found;
  for (std::size_t k = 1; k + 1 < amplitude.size(); ++k) {
    if (amplitude[k] > amplitude[k - 1] && amplitude[k] >= amplitude[k + 1] &&
        stands_out(amplitude, k)) {
      found.push_back(vertex(spectrum, k));
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const SpectralPeak& a, const SpectralPeak& b) {
    return a.amplitude > b.amplitude;
  });
  const auto slow = [&](const SpectralPeak& peak) {
    return peak.frequency * spectrum.duration < kHannMainLobe;
  };
  const auto largest = std::find_if_not(found.begin(), found.end(), slow);
  if (largest == found.end()) return {};
  const double least =
      std::max({kQuartiles * lower_quartile(amplitude), floor * largest->amplitude,
                kRoundOff * *std::max_element(amplitude.begin(), amplitude.end())});
  std::vector<SpectralPeak> sources;
  std::vector<SpectralPeak> peaks;
  for (const SpectralPeak& peak : found) {
    if (peak.amplitude < least) break;
    double leaked = 0.0;
    for (const SpectralPeak& source : sources) {
      if (slow(source)) {
        leaked += kSlowLeak * source.amplitude * envelope(peak.frequency * spectrum.duration);
        continue;
      }
      const double distance = std::fabs(peak.frequency - source.frequency) * spectrum.duration;
      const double distance_to_image = (peak.frequency + source.frequency) * spectrum.duration;
      leaked += kLeak * source.amplitude * (envelope(distance) + envelope(distance_to_image));
    }
    if (peak.amplitude <= leaked) continue;
    sources.push_back(peak);
    if (!slow(peak)) peaks.push_back(peak);
  }
  return peaks;
}

}  // namespace plastica::theory
