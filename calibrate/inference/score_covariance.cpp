#include "calibrate/inference/score_covariance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

namespace plastica::calibrate {
namespace {

using Eigen::Index;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::VectorXd;

/// What neighbours have in common.
double correlation_of_neighbours(const VectorXd& residual) {
  const Index n = residual.size();
  const double squares = residual.squaredNorm();
  if (n < 2 || !(squares > 0.0)) return 0.0;
  return residual.head(n - 1).dot(residual.tail(n - 1)) / squares;
}

/// What is left of each row without so much of the one before; the first one has none.
template <class Matrix>
Matrix whitened(const Matrix& rows, double rho) {
  return rows.bottomRows(rows.rows() - 1) - rho * rows.topRows(rows.rows() - 1);
}

/// How many neighbours on one side count.
Index bandwidth(const VectorXd& residual) {
  const Index n = residual.size();
  const double rho = std::clamp(correlation_of_neighbours(residual), -0.999, 0.999);
  const double a = 4.0 * rho * rho / std::pow(1.0 - rho * rho, 2);
  const double lags = 1.1447 * std::cbrt(a * static_cast<double>(n));
  return std::min(static_cast<Index>(lags), n - 1);
}

}  // namespace

std::vector<double> score_covariance(std::span<const double> slopes,
                                     std::span<const double> residual) {
  constexpr double kMost = 0.97;
  const auto n = static_cast<Index>(residual.size());
  const auto parameters = static_cast<Index>(slopes.size()) / n;
  VectorXd r = Eigen::Map<const VectorXd>(residual.data(), n);
  Rows score = r.asDiagonal() * Eigen::Map<const Rows>(slopes.data(), n, parameters);
  double unit = 1.0;
  const double seen = correlation_of_neighbours(r);
  if (seen > 0.0 && n > 2) {
    const double k = static_cast<double>(parameters);
    const double taken = (k * (1.0 + seen) + 2.0 * seen) / static_cast<double>(n);
    const double rho = std::min(seen + taken, kMost);
    score = whitened(score, rho);
    r = whitened(r, rho);
    // One sample less, and what was taken out of each.
    unit = static_cast<double>(n) / static_cast<double>(n - 1) / std::pow(1.0 - rho, 2);
  }
  Rows covariance = score.transpose() * score;
  const Index most = bandwidth(r);
  for (Index lag = 1; lag <= most; ++lag) {
    const double weight = 1.0 - static_cast<double>(lag) / static_cast<double>(most + 1);
    const Index left = score.rows() - lag;
    const Rows product = score.bottomRows(left).transpose() * score.topRows(left);
    covariance += weight * (product + product.transpose());
  }
  covariance *= unit;
  return {covariance.data(), covariance.data() + covariance.size()};
}

}  // namespace plastica::calibrate
