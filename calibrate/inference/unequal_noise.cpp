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

/// Degrees of freedom of a mean of squares with these weights.
double degrees_of_mean(const ArrayXd& weight) {
  return std::pow(weight.sum(), 2) / weight.square().sum();
}

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
  const Index parameters = fit.influence.rows();
  if (parameters == 0 || fit.residual.size() < parameters + kFew) return false;
  const ArrayXd squares = unit_squares(fit);
  for (Index k = 0; k < parameters; ++k) {
    ArrayXd decide = fit.influence.row(k).transpose().array().square();
    const double largest = decide.maxCoeff();
    if (!(largest > 0.0)) continue;
    decide /= largest;
    const ArrayXd others = 1.0 - decide;
    const double inside = (decide * squares).sum() / decide.sum();
    const double outside = (others * squares).sum() / others.sum();
    if (!(inside > 0.0 && outside > 0.0)) continue;
    const double p =
        probability_of(inside / outside, degrees_of_mean(decide), degrees_of_mean(others));
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
