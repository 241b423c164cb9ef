#include "calibrate/inference/unequal_noise.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Of what a fit leaves of a residual: less is rounding.
constexpr double kLeast = 0.05;

ArrayXd unit_squares(const FitInfluence& fit) {
  return fit.residual.array().square() / fit.left.array().max(kLeast);
}

/// A mean of squares with weights, and its degrees of freedom.
struct WeighedMean {
  double sum = 0.0, squared = 0.0, value = 0.0;

  template <typename Weight>
  WeighedMean(const Weight& weight, const ArrayXd& squares)
      : sum(weight.sum()), squared(weight.square().sum()), value((weight * squares).sum() / sum) {}
  double degrees() const { return sum * sum / squared; }
};

/// Probability that a ratio of two variances is further from one on either side.
double probability_of(double ratio, double above, double below) {
  const double a = 2.0 / (9.0 * above), b = 2.0 / (9.0 * below);
  const double root = std::cbrt(ratio);
  const double z = ((1.0 - b) * root - (1.0 - a)) / std::sqrt(b * root * root + a);
  return std::erfc(std::fabs(z) / std::sqrt(2.0));
}

}  // namespace

bool is_noise_unequal(const FitInfluence& fit) {
  constexpr double kChance = 0.01;
  constexpr Index kFew = 10;  // residuals to compare, beyond those that the parameters took
  const Index parameters = fit.influence.cols();
  if (parameters == 0 || fit.residual.size() < parameters + kFew) return false;
  const ArrayXd squares = unit_squares(fit);
  for (Index k = 0; k < parameters; ++k) {
    const auto influence = fit.influence.col(k).array();
    const double largest = influence.abs().maxCoeff();
    if (!(largest > 0.0)) continue;
    const ArrayXd decide = (influence / largest).square();
    const WeighedMean inside(decide, squares), outside(1.0 - decide, squares);
    if (!(inside.value > 0.0 && outside.value > 0.0)) continue;
    const double p =
        probability_of(inside.value / outside.value, inside.degrees(), outside.degrees());
    if (p * static_cast<double>(parameters) < kChance) return true;
  }
  return false;
}

Eigen::VectorXd own_variances(const FitInfluence& fit) {
  return (unit_squares(fit) / (1.0 - fit.leverage.array()).max(kLeast)).matrix();
}

double degrees_of_own(const Eigen::VectorXd& squared_influence, const Eigen::VectorXd& variance,
                      double most) {
  constexpr double kLeastDegrees = 2.0, kFourthMoment = 3.0;
  const ArrayXd terms = squared_influence.array() * variance.array();
  const double squares = terms.square().sum() / kFourthMoment;
  if (!(squares > 0.0)) return most;
  return std::clamp(std::pow(terms.sum(), 2) / squares, std::min(kLeastDegrees, most), most);
}

}  // namespace plastica::calibrate
