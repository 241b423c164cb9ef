#include "plastica/theory/beam_vibration.hpp"

#include <cmath>
#include <numbers>

#include "plastica/base/domain.hpp"

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

/// sqrt(E I/(rho A L^4)) [rad/s].
double unit_frequency(const VibratingBeam& beam) {
  return std::sqrt(beam.bending_stiffness / beam.mass_per_length) / (beam.length * beam.length);
}

}  // namespace

double frequency_root(BeamEnds ends, int mode) {
  require_domain(mode >= 1, "mode >= 1");
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

double circular_frequency(BeamEnds ends, int mode, const VibratingBeam& beam) {
  const double root = frequency_root(ends, mode);
  return root * root * unit_frequency(beam);
}

double rayleigh_cantilever_frequency(int mode, const VibratingBeam& beam) {
  require_domain(mode >= 1, "mode >= 1");
  const double gyration =
      beam.rotary_inertia / (beam.mass_per_length * beam.length * beam.length);  // r^2
  const auto q_of = [&](double p) { return p / std::sqrt(1.0 + p * p * gyration); };
  // The determinant over p^4 cosh q, so that it neither overflows nor vanishes at p = 0.
  const auto determinant = [&](double p) {
    const double q = q_of(p);
    const double s = q * q / (p * p);
    return 2.0 * s / std::cosh(q) + (1.0 + s * s) * std::cos(p) -
           std::sqrt(s) * (1.0 - s) * std::tanh(q) * std::sin(p);
  };
  const double sign = mode % 2 == 1 ? 1.0 : -1.0;  // on the lower side
  double low = (mode - 1) * pi;
  double high = mode * pi;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (sign * determinant(middle) > 0.0 ? low : high) = middle;
  }
  return high * q_of(high) * unit_frequency(beam);
}

double clamped_free_torsion_frequency(int mode, double length, double torsional_stiffness,
                                      double polar_inertia) {
  require_domain(mode >= 1, "mode >= 1");
  return (mode - 0.5) * pi / length * std::sqrt(torsional_stiffness / polar_inertia);
}

double released_cantilever_tip(const VibratingBeam& beam, double acceleration, double time,
                               int modes) {
  require_domain(modes >= 1, "modes >= 1");
  double sum = 0.0;
  for (int n = modes; n >= 1; --n) {  // the small terms first
    const double x = frequency_root(BeamEnds::ClampedFree, n);
    const double omega = x * x * unit_frequency(beam);
    const double s =
        (1.0 + std::cos(x) / std::cosh(x)) / (std::tanh(x) + std::sin(x) / std::cosh(x));
    const double half_sine = std::sin(0.5 * omega * time);
    const double term = 4.0 * s / (x * omega * omega) * 2.0 * half_sine * half_sine;
    sum += n % 2 == 1 ? term : -term;
  }
  return acceleration * sum;
}

}  // namespace plastica::theory
