#include "calibrate/inference/score_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Residual = Eigen::Map<const Eigen::VectorXd>;

/// How many neighbours on one side count.
Index bandwidth(const Residual& residual) {
  const Index n = residual.size();
  const double squares = residual.squaredNorm();
  if (n < 2 || !(squares > 0.0)) return 0;
  const double products = residual.head(n - 1).dot(residual.tail(n - 1));
  const double rho = std::clamp(products / squares, -0.999, 0.999);
  const double a = 4.0 * rho * rho / std::pow(1.0 - rho * rho, 2);
  const double lags = 1.1447 * std::cbrt(a * static_cast<double>(n));
  return std::min(static_cast<Index>(lags), n - 1);
}

}  // namespace

std::vector<double> score_covariance(std::span<const double> slopes,
                                     std::span<const double> residual) {
  const auto n = static_cast<Index>(residual.size());
  const auto parameters = static_cast<Index>(slopes.size()) / n;
  const Residual r(residual.data(), n);
  const Rows score = r.asDiagonal() * Eigen::Map<const Rows>(slopes.data(), n, parameters);
  Rows covariance = score.transpose() * score;
  const Index most = bandwidth(r);
  for (Index lag = 1; lag <= most; ++lag) {
    const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(most + 1);
    const Rows product = score.bottomRows(n - lag).transpose() * score.topRows(n - lag);
    covariance += weight * (product + product.transpose());
  }
  return {covariance.data(), covariance.data() + covariance.size()};
}

}  // namespace plastica::calibrate
