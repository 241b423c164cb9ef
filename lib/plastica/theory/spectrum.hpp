#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace plastica::theory {

/// Amplitudes of the sines that a sampled history consists of.
///
/// T the length of the history, two sines are told apart from `kApart`/T on, and what is slower
/// than `kHannMainLobe`/T is not told from its mean. Faster than half the sampling rate nothing is
/// seen: it appears folded back below it.
struct Spectrum {
  double duration = 0.0;          ///< T = n_samples x time step [s]
  std::vector<double> frequency;  ///< [Hz], evenly spaced from 0 to half the sampling rate (n_bins)
  std::vector<double> amplitude;  ///< of a sine at that frequency, in the history's unit (n_bins)
};

/// One sine of a history.
struct SpectralPeak {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< in the history's unit
};

/// Half the width of the window's main lobe in units of 1/T: a sine reaches that far.
inline constexpr double kHannMainLobe = 2.0;
/// Distance in units of 1/T from which on the spectrum of two sines of one amplitude falls to half
/// of them in between, whatever their phases: 2 W(d/2) < 1/2.
inline constexpr double kApart = 3.0;
/// Shorter histories have no spectrum.
inline constexpr std::size_t kFewestSamples = 16;

/// Spectrum of a history by a discrete Fourier transform.
///
/// The mean under the window is taken off and the history multiplied by the periodic Hann window
/// w_k = (1 - cos(2 pi k/n))/2, whose transform at a distance of d/T from a sine is
/// W(d) = sin(pi d)/(pi d (1 - d^2)) of its amplitude: zero from 2/T on but for side lobes of at
/// most 2.7 % that fall as 1/(pi d^3). Zeros behind it, to the power of two that is at least four
/// times as long, refine the bins to at most 1/(4 T).
///
/// Source: F. J. Harris, On the use of windows for harmonic analysis with the discrete Fourier
/// transform, Proc. IEEE 66 (1978) 51-83, section V.C.
///
/// @param values     at even times, all finite (n_samples)
/// @param time_step  between two samples [s], > 0
/// @return           without bins where n_samples < kFewestSamples
Spectrum amplitude_spectrum(std::span<const double> values, double time_step);

/// The sines that stand out of a spectrum, the largest amplitude first.
///
/// A peak is the vertex of the parabola through the logarithms of a largest amplitude and its two
/// neighbours. For a lone sine, with ln W(d) = -a d^2 - b d^4 - ..., a = pi^2/6 - 1,
/// b = pi^4/180 - 1/2, and bins of h/T, the parabola is off by at most (b/a) h^3 sqrt(3)/9 /T, that
/// is 2e-4/T at h = 1/4. Its own image below zero moves it by up to 1/(2 a D^3)/T, D = 2 f T, and
/// so does a neighbour of the same amplitude at a distance of D/T.
///
/// What is no peak: what lies below 2/T; what another sine's side lobes may have made, by twice
/// their envelope; what is below eight times the lower quartile of all bins, which white noise
/// exceeds in one of 1e8; and what is below `floor`.
///
/// @param floor  fraction of the largest amplitude from 2/T on [1], 0 … 1
std::vector<SpectralPeak> spectral_peaks(const Spectrum& spectrum, double floor = 1e-3);

}  // namespace plastica::theory
