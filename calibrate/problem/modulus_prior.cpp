#include "calibrate/problem/modulus_prior.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace plastica::calibrate {
namespace {

/// Errors of a slope that its scatter does not show, as a fraction of it.
constexpr double kHidden = 0.02;

/// A straight line through the samples of the first loading between two stresses.
struct Slope {
  double value = 0.0;
  double variance = 0.0;
};
std::optional<Slope> slope_between(const Curve& curve, double low, double high, double end) {
  constexpr std::size_t kFew = 4;
  std::vector<double> x, y;
  for (std::size_t i = 0; i < curve.size() && curve.stress[i] <= end; ++i) {
    if (curve.stress[i] < low || curve.stress[i] > high) continue;
    x.push_back(curve.strain[i]);
    y.push_back(curve.stress[i]);
  }
  if (x.size() < kFew) return std::nullopt;
  const auto n = static_cast<double>(x.size());
  const double x_mean = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double y_mean = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double sxx = 0.0, sxy = 0.0, syy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - x_mean) * (x[i] - x_mean);
    sxy += (x[i] - x_mean) * (y[i] - y_mean);
    syy += (y[i] - y_mean) * (y[i] - y_mean);
  }
  if (!(sxx > 0.0)) return std::nullopt;
  const double slope = sxy / sxx;
  return Slope{slope, std::max(0.0, syy - slope * sxy) / (n - 2.0) / sxx};
}

/// What a slope owes to the window in which it was measured [Pa]: the standard error of the mean of
/// the slopes of its quarters, if these differ by more than their scatter explains.
double error_of_window(const Target& target) {
  constexpr std::size_t kQuarters = 4;
  constexpr double kDiffer = 16.27;  // chi^2 of 3 degrees of freedom, exceeded in one of a thousand
  const Characteristics& c = target.characteristics;
  const double low = c.modulus_window_low, high = c.modulus_window_high;
  std::array<Slope, kQuarters> slopes;
  double mean = 0.0, variance = 0.0;
  for (std::size_t q = 0; q < kQuarters; ++q) {
    const double step = (high - low) / static_cast<double>(kQuarters);
    const double from = low + step * static_cast<double>(q);
    const auto slope = slope_between(target.corrected, from, from + step, high);
    if (!slope) return 0.0;
    slopes[q] = *slope;
    mean += slope->value / static_cast<double>(kQuarters);
    variance += slope->variance / static_cast<double>(kQuarters);
  }
  double squares = 0.0;
  for (const Slope& slope : slopes) squares += std::pow(slope.value - mean, 2);
  if (squares <= kDiffer * variance) return 0.0;
  return std::sqrt(squares / static_cast<double>(kQuarters * (kQuarters - 1)));
}

}  // namespace

std::optional<ModulusPrior> modulus_prior(const Target& target, const FitOptions& options) {
  const Characteristics& c = target.characteristics;
  const bool is_measured = target.test == Test::Tension && c.modulus_method == "regression" &&
                           c.youngs_modulus && c.youngs_modulus_stderr;
  const bool is_free = std::ranges::any_of(options.parameters, [](const Parameter& p) {
    return p.role == ParameterRole::Free && p.field->material == MaterialField::YoungsModulus;
  });
  if (!options.modulus_prior || !is_measured || !is_free) return std::nullopt;
  return ModulusPrior{*c.youngs_modulus,
                      std::hypot(std::hypot(*c.youngs_modulus_stderr, error_of_window(target)),
                                 kHidden * *c.youngs_modulus),
                      0.0};
}

}  // namespace plastica::calibrate
