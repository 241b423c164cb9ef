#include "calibrate/search/whitened.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

/// Added to the diagonal over itself, for directions in which the squares do not change.
constexpr double kFlat = 1e-10;

}  // namespace

Whitened::Whitened(const Problem& problem, const std::vector<double>& centre,
                   const SquaresModel& model)
    : problem_(problem), centre_(centre), by_x_(centre.size()) {
  for (std::size_t i = 0; i < centre.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const bool out = (centre[i] <= problem.lower[i] && model.gradient[k] > 0.0) ||
                     (centre[i] >= problem.upper[i] && model.gradient[k] < 0.0);
    if (!out && model.normal(k, k) > 0.0) free_.push_back(i);
  }
  const auto m = static_cast<Eigen::Index>(free_.size());
  Eigen::MatrixXd normal(m, m);
  for (Eigen::Index a = 0; a < m; ++a) {
    for (Eigen::Index b = 0; b < m; ++b) {
      normal(a, b) = model.normal(static_cast<Eigen::Index>(free_[static_cast<std::size_t>(a)]),
                                  static_cast<Eigen::Index>(free_[static_cast<std::size_t>(b)]));
    }
    normal(a, a) *= 1.0 + kFlat;
  }
  const Eigen::LLT<Eigen::MatrixXd> root(2.0 * normal);
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(m, m);
  transform_ = root.matrixU().solve(unit);
  if (root.info() != Eigen::Success || !transform_.allFinite()) {
    transform_ = normal.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
  }
}

std::vector<double> Whitened::point(std::span<const double> z) const {
  const auto m = static_cast<Eigen::Index>(free_.size());
  const Eigen::VectorXd dx = transform_ * Eigen::Map<const Eigen::VectorXd>(z.data(), m);
  std::vector<double> x = centre_;
  for (std::size_t a = 0; a < free_.size(); ++a) {
    const std::size_t i = free_[a];
    x[i] =
        std::clamp(x[i] + dx[static_cast<Eigen::Index>(a)], problem_.lower[i], problem_.upper[i]);
  }
  return x;
}

double Whitened::cost(std::span<const double> z, std::span<double> gradient) {
  const std::vector<double> x = point(z);
  if (gradient.empty()) return problem_.cost(x, {});
  const double cost = problem_.cost(x, by_x_);
  const auto m = static_cast<Eigen::Index>(free_.size());
  Eigen::VectorXd free_gradient(m);
  for (std::size_t a = 0; a < free_.size(); ++a) {
    const std::size_t i = free_[a];
    const bool held = x[i] <= problem_.lower[i] || x[i] >= problem_.upper[i];
    free_gradient[static_cast<Eigen::Index>(a)] = held ? 0.0 : by_x_[i];
  }
  Eigen::Map<Eigen::VectorXd>(gradient.data(), m) = transform_.transpose() * free_gradient;
  return cost;
}

Problem Whitened::problem(double reach) {
  const std::size_t m = free_.size();
  Problem problem;
  problem.lower.assign(m, -reach);
  problem.upper.assign(m, reach);
  problem.start.assign(m, 0.0);
  problem.cost = [this](std::span<const double> z, std::span<double> gradient) {
    return cost(z, gradient);
  };
  return problem;
}

}  // namespace plastica::calibrate
