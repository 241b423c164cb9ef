#include "calibrate/search/minimize_alone.hpp"

#include <cmath>
#include <vector>

namespace plastica::calibrate {
namespace {

double power_of_two_near(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

/// z_i = scale_i x_i.
std::vector<double> scales_of(const Problem& problem) {
  const std::size_t n = problem.start.size();
  std::vector<double> scale(n, 1.0), gradient(n), normal(n * n);
  if (!std::isfinite(problem.squares(problem.start, gradient, normal))) return scale;
  for (std::size_t i = 0; i < n; ++i) {
    const double curvature = 2.0 * normal[i * n + i];
    const bool matters = std::isfinite(curvature) && curvature > kMinCurvature;
    if (matters) scale[i] = power_of_two_near(std::sqrt(curvature));
  }
  return scale;
}

}  // namespace

Minimum minimize_alone(const Problem& problem, const MinimizeOptions& how) {
  if (how.algorithm == kGaussNewton) return minimize(problem, how);
  const std::vector<double> scale = scales_of(problem);
  const std::size_t n = scale.size();
  std::vector<double> x(n);
  Problem scaled;
  for (std::size_t i = 0; i < n; ++i) {
    scaled.lower.push_back(problem.lower[i] * scale[i]);
    scaled.upper.push_back(problem.upper[i] * scale[i]);
    scaled.start.push_back(problem.start[i] * scale[i]);
  }
  scaled.cost = [&](std::span<const double> z, std::span<double> gradient) {
    for (std::size_t i = 0; i < n; ++i) x[i] = z[i] / scale[i];
    const double cost = problem.cost(x, gradient);
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] /= scale[i];
    return cost;
  };
  Minimum end = minimize(scaled, how);
  for (std::size_t i = 0; i < end.x.size(); ++i) end.x[i] /= scale[i];
  return end;
}

}  // namespace plastica::calibrate
