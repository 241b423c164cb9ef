#include "calibrate/target/deming_line.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/target/characteristics.hpp"

namespace plastica::calibrate {
namespace {

using Values = std::span<const double>;

}  // namespace

DemingLine deming_line(Values strain, Values stress, double noise) {
  const double n = static_cast<double>(strain.size());
  double mean_strain = 0.0;
  double mean_stress = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    mean_strain += strain[i];
    mean_stress += stress[i];
  }
  mean_strain /= n;
  mean_stress /= n;
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const double x = strain[i] - mean_strain;
    const double y = stress[i] - mean_stress;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  DemingLine regression;
  ElasticLine& line = regression.line;
  line.samples = strain.size();
  if (!(sxx > 0.0)) return regression;
  line.modulus = sxy / sxx;
  const double of_strain = noise_over_rows(strain);
  if (of_strain > 0.0 && sxy > 0.0) {
    const double ratio = std::pow(noise_over_rows(stress) / of_strain, 2);
    const double excess = syy - ratio * sxx;
    // Two forms of one root: neither loses digits.
    const double root = std::hypot(excess, 2.0 * std::sqrt(ratio) * sxy);
    line.modulus =
        excess > 0.0 ? (excess + root) / (2.0 * sxy) : 2.0 * ratio * sxy / (root - excess);
    regression.foot_fraction = 1.0 / (1.0 + ratio / (line.modulus * line.modulus));
  }
  line.zero_strain = mean_strain - mean_stress / line.modulus;
  double squares = 0.0;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const double r = stress[i] - mean_stress - line.modulus * (strain[i] - mean_strain);
    squares += r * r;
  }
  const double scatter = std::max(noise, std::sqrt(squares / (n - 2.0)));
  line.modulus_stderr = scatter / std::sqrt(sxx);
  const double arm = mean_strain - line.zero_strain;
  line.zero_strain_stderr = scatter / line.modulus * std::sqrt(1.0 / n + arm * arm / sxx);
  return regression;
}

}  // namespace plastica::calibrate
