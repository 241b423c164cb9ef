#include "calibrate/inference/normal_matrices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "calibrate/inference/small_matrices.hpp"
#include "calibrate/problem/weighted_squares.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRankTolerance = 1e-12;
/// What takes no larger part in the directions that the curve does not show is determined.
constexpr double kTakesPartInCurve = 1e-3;

NormalMatrices normal_matrices(const Misfit::Details& d, const std::vector<std::size_t>& columns,
                               const std::vector<double>& size) {
  const auto m = static_cast<Eigen::Index>(columns.size());
  const MatrixXd none = MatrixXd::Zero(m, m);
  NormalMatrices normal{none, none, none, none, VectorXd::Zero(m), {}, {}, {}, {}, {}};
  const std::size_t samples = d.residual.size();
  const auto column = [&](Eigen::Index k) {
    const std::size_t begin = columns[static_cast<std::size_t>(k)] * samples;
    return std::span(d.jacobian).subspan(begin, samples);
  };
  const auto size_of = [&](Eigen::Index k) { return size[columns[static_cast<std::size_t>(k)]]; };
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index i = j; i < m; ++i) {
      const double unit = size_of(i) * size_of(j);
      const TwiceWeighted sums = twice_weighted_product(d.weight, column(i), column(j));
      normal.a(i, j) = unit * sums.once;
      normal.b(i, j) = unit * sums.twice;
    }
  }
  const double total = std::accumulate(d.weight.begin(), d.weight.end(), 0.0);
  for (const Misfit::Details::ActivePrior& prior : d.priors) {
    for (Eigen::Index k = 0; k < m; ++k) {
      if (columns[static_cast<std::size_t>(k)] != prior.column) continue;
      const double per_deviation = size_of(k) / prior.standard_deviation;
      const double in_a = total * d.prior_variance * per_deviation * per_deviation;
      normal.a(k, k) += in_a;
      (prior.stated ? normal.stated : normal.prior)(k, k) +=
          std::pow(total * d.prior_variance * per_deviation, 2);
      if (prior.stated) normal.stated_in_a(k) += in_a;
    }
  }
  normal.a.triangularView<Eigen::StrictlyUpper>() = normal.a.transpose();
  normal.b.triangularView<Eigen::StrictlyUpper>() = normal.b.transpose();
  return normal;
}

}  // namespace

NormalMatrices keep_identified(const Misfit::Details& d, const std::vector<double>& size,
                               double stress, std::vector<std::size_t>& columns) {
  double total = 0.0;
  for (const double w : d.weight) total += w;
  NormalMatrices normal = normal_matrices(d, columns, size);
  const auto keep = [&](const std::vector<Eigen::Index>& kept) {
    if (kept.size() == columns.size()) return;
    std::vector<std::size_t> left;
    left.reserve(kept.size());
    for (const Eigen::Index k : kept) left.push_back(columns[static_cast<std::size_t>(k)]);
    columns = left;
    normal = normal.of(kept);
  };
  std::vector<Eigen::Index> identifiable;
  std::vector<std::size_t> blank;
  for (Eigen::Index i = 0; i < normal.a.rows(); ++i) {
    if (normal.a(i, i) > kRankTolerance * kRankTolerance * stress * stress * total) {
      identifiable.push_back(i);
    } else {
      blank.push_back(columns[static_cast<std::size_t>(i)]);
    }
  }
  keep(identifiable);
  normal.blank = blank;
  if (columns.empty()) return normal;
  const UnitDirections directions(normal.a);
  const Eigen::Index unseen = (directions.values.array() < kRankTolerance).count();
  const MatrixXd vectors = directions.vectors.leftCols(unseen);
  const std::vector<std::size_t> shown = columns;
  std::vector<Eigen::Index> kept;
  std::vector<bool> is_determined;
  const std::vector<Eigen::Index> held = held_against(vectors);
  for (Eigen::Index k = 0; k < normal.a.rows(); ++k) {
    if (std::ranges::find(held, k) != held.end()) continue;
    kept.push_back(k);
    is_determined.push_back(unseen == 0 || vectors.row(k).norm() <= kTakesPartInCurve);
  }
  keep(kept);
  normal.is_determined = std::move(is_determined);
  normal.unseen = vectors;
  normal.shown = shown;
  normal.blank = std::move(blank);
  normal.unit = directions.size;
  return normal;
}

bool NormalMatrices::determine(const std::vector<double>& gradient,
                               const std::vector<double>& size) const {
  const auto squared = [&](const std::vector<std::size_t>& columns) {
    double sum = 0.0;
    for (const std::size_t k : columns) sum += std::pow(size[k] * gradient[k], 2);
    return sum;
  };
  const double of_blank = squared(blank);
  const double all = of_blank + squared(shown);
  if (of_blank > kTakesPartInCurve * kTakesPartInCurve * all) return false;
  if (unseen.size() == 0) return true;
  VectorXd own(unseen.rows());
  for (Eigen::Index k = 0; k < own.size(); ++k) {
    const std::size_t column = shown[static_cast<std::size_t>(k)];
    own(k) = unit(k) * size[column] * gradient[column];
  }
  return (unseen.transpose() * own).norm() <= kTakesPartInCurve * own.norm();
}

}  // namespace plastica::calibrate
