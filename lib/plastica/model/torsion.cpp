#include "plastica/model/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica {
namespace {

using std::numbers::pi;

// In the sums below tanh is split into 1, summed in closed form, and a rest; what is left dies at
// least like exp(-n pi/2), so that eleven odd terms reach rounding.
constexpr int kLastTerm = 21;

/// 1 - tanh(x) without cancellation.
double one_minus_tanh(double x) { return 2.0 / (std::exp(2.0 * x) + 1.0); }

/// 1 + exp(x); below -40 that is 1, to the last digit.
double one_plus_exp(double x) { return x < -40.0 ? 1.0 : 1.0 + std::exp(x); }

/// Below this exp is 0 in double precision, and slow to say so.
constexpr double kUnderflow = -746.0;

/// Largest shear stress of a rectangle over G theta s.
double long_side_stress(double ratio) {
  double sum = 0.0;
  for (int n = kLastTerm; n >= 1; n -= 2) {
    sum += 1.0 / (n * n * std::cosh(n * pi * ratio / 2.0));
  }
  return 1.0 - 8.0 / (pi * pi) * sum;
}

}  // namespace

double saint_venant_beta(double ratio) {
  constexpr double kZeta5 = 1.0369277551433699;
  double rest = 0.0;
  for (int n = kLastTerm; n >= 1; n -= 2) {
    rest += one_minus_tanh(n * pi * ratio / 2.0) / std::pow(n, 5);
  }
  const double sum = 31.0 / 32.0 * kZeta5 - rest;
  return 1.0 / 3.0 - 64.0 / std::pow(pi, 5) / ratio * sum;
}

double saint_venant_alpha(double ratio) {
  return saint_venant_beta(ratio) / long_side_stress(ratio);
}

double saint_venant_eta(double ratio) {
  constexpr double kCatalan = 0.91596559417721902;
  double rest = 0.0;
  for (int n = kLastTerm; n >= 1; n -= 2) {
    const double sign = (n / 2) % 2 == 0 ? 1.0 : -1.0;
    rest += sign * one_minus_tanh(n * pi * ratio / 2.0) / (n * n);
  }
  return 8.0 / (pi * pi) * (kCatalan - rest) / long_side_stress(ratio);
}

double saint_venant_perimeter_stress(double ratio, bool long_side, double position) {
  if (position >= 1.0) return 0.0;
  // Slowest next to a corner, where the terms only fall like 1/n^2.
  constexpr int kLastNearCorner = 2001;
  double sum = 0.0;
  for (int n = kLastNearCorner; n >= 1; n -= 2) {
    const double end = n * pi * ratio / 2.0;
    if (long_side) {
      // cosh(end position)/cosh(end)
      const double away = end * (position - 1.0);
      if (away < kUnderflow) continue;
      sum +=
          std::exp(away) * one_plus_exp(-2.0 * end * position) / one_plus_exp(-2.0 * end) / n / n;
    } else {
      const double sign = (n / 2) % 2 == 0 ? 1.0 : -1.0;
      // As above, tanh is 1 there.
      const double tanh_of_end = end > 20.0 ? 1.0 : 1.0 - one_minus_tanh(end);
      sum += sign * tanh_of_end * std::cos(n * pi * position / 2.0) / n / n;
    }
  }
  const double stress = 8.0 / (pi * pi) * sum;
  return (long_side ? 1.0 - stress : stress) / long_side_stress(ratio);
}

double saint_venant_shear(double width, double height, double x, double y) {
  // phi = a^2 - s^2 - (32 a^2/pi^3) sum +-cos(n pi s/2a) cosh(n pi t/2a)/(n^3 cosh(n pi b/2a)),
  // with s along the shorter side 2a and t along the longer one 2b.
  const double a = 0.5 * std::min(width, height);
  const double b = 0.5 * std::max(width, height);
  const double s = width <= height ? x : y;
  const double t = std::fabs(width <= height ? y : x);
  constexpr int kMaxTerms = 4001;
  double by_s = 0.0;
  double by_t = 0.0;
  for (int n = 1; n <= kMaxTerms; n += 2) {
    const double k = n * pi / (2.0 * a);
    const double left = std::exp(k * (t - b)) / (n * n);
    if (left < 1e-10) break;
    const double sign = (n / 2) % 2 == 0 ? 1.0 : -1.0;
    const double mirrored = std::exp(-2.0 * k * t);
    const double part = sign * left / (1.0 + std::exp(-2.0 * k * b));
    by_s += part * (1.0 + mirrored) * std::sin(k * s);
    by_t += part * (1.0 - mirrored) * std::cos(k * s);
  }
  const double scale = 16.0 * a / (pi * pi);
  return std::hypot(scale * by_s - 2.0 * s, scale * by_t);
}

double sand_heap_modulus_rectangle(double width, double height) {
  const double c = std::max(width, height);
  const double s = std::min(width, height);
  return s * s * (3.0 * c - s) / 6.0;
}

}  // namespace plastica
