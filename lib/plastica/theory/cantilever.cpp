#include "plastica/theory/cantilever.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace plastica::theory {
namespace {

using std::numbers::pi;

/// Newton's method from a guess within 0.03 of a simple root: five steps reach rounding.
template <typename Function, typename Slope>
double refined(double x, const Function& f, const Slope& slope) {
  for (int i = 0; i < 8; ++i) x -= f(x) / slope(x);
  return x;
}

/// Root of cos x + sign/cosh x near (2n -+ 1) pi/2; divided by cosh so that it cannot overflow.
double cosine_root(double guess, double sign) {
  return refined(
      guess, [&](double x) { return std::cos(x) + sign / std::cosh(x); },
      [&](double x) { return -std::sin(x) - sign * std::tanh(x) / std::cosh(x); });
}

}  // namespace

double tip_deflection_ratio(double p) {
  assert(p >= 0.0 && p <= 1.5);
  if (p <= 1.0) return p;
  return (5.0 - (3.0 + p) * std::sqrt(3.0 - 2.0 * p)) / (p * p);
}

double plastic_zone_ratio(double p) { return std::max(0.0, 1.0 - 1.0 / std::max(p, 1.0)); }

double residual_tip_ratio(double p) { return tip_deflection_ratio(p) - p; }

double frequency_root(BeamEnds ends, int mode) {
  assert(mode >= 1);
  switch (ends) {
    case BeamEnds::ClampedFree:
      // The first root, 1.875, is far from its asymptote pi/2.
      return cosine_root(mode == 1 ? 1.875 : (mode - 0.5) * pi, 1.0);
    case BeamEnds::ClampedClamped:
    case BeamEnds::FreeFree: return cosine_root((mode + 0.5) * pi, -1.0);
    case BeamEnds::ClampedPinned:
      return refined((mode + 0.25) * pi,
                     [](double x) { return std::sin(x) - std::cos(x) * std::tanh(x); },
                     [](double x) {
                       const double t = std::tanh(x);
                       return std::cos(x) + std::sin(x) * t - std::cos(x) * (1.0 - t * t);
                     });
    case BeamEnds::PinnedPinned: break;
  }
  return mode * pi;
}

double circular_frequency(BeamEnds ends, int mode, double bending_stiffness, double mass_per_length,
                          double length) {
  const double beta = frequency_root(ends, mode) / length;
  return beta * beta * std::sqrt(bending_stiffness / mass_per_length);
}

}  // namespace plastica::theory
