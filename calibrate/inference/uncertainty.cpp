#include "calibrate/inference/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "calibrate/inference/lack_of_fit.hpp"
#include "calibrate/inference/material_interval.hpp"
#include "calibrate/inference/normal_matrices.hpp"
#include "calibrate/inference/not_a_number.hpp"
#include "calibrate/inference/small_matrices.hpp"
#include "calibrate/inference/unequal_noise.hpp"
#include "calibrate/inference/verdict.hpp"
#include "calibrate/problem/weighted_squares.hpp"

namespace plastica::calibrate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Parameters that shape the stress (not the break strain), and what the curve says of them.
struct StressErrors {
  std::vector<std::size_t> columns;  ///< active indices of which the curve says anything …
  std::vector<bool> is_determined;   ///< … and which of them it determines by themselves
  bool has_break = true;             ///< whether it determines the permanent strain at the break
  /// Of those, from residuals, from the slope's prior and from stated ones, SI.
  MatrixXd covariance, of_prior, of_stated;
  /// A^-1, J^T W^2 J, P of the slope's prior and of stated ones, over the sizes of both.
  MatrixXd inverse, weighted, prior, stated;
  VectorXd stated_in_a;      ///< the stated priors' part of the diagonal of A
  VectorXd of_shift;         ///< g, SI; empty where the strain's zero has no error
  MatrixXd of_turns;         ///< of errors of the strain where it turns, SI
  std::vector<double> size;  ///< of the active parameters, SI (n)
  double variance = 0.0;     ///< of the noise [Pa^2]
  double degrees_of_freedom = 1.0;
  /// Where noise is unequal: A^-1 J^T W of the samples that enter, SI, and their variances.
  MatrixXd influence;
  VectorXd own;
};

/// By how much an error of the strain's shift moves the parameters. @param error  [1]
VectorXd shift_effect(const Misfit::Details& d, double error, const StressErrors& of_stress) {
  const auto m = static_cast<Eigen::Index>(of_stress.columns.size());
  const std::size_t samples = d.residual.size();
  VectorXd pull(m);
  VectorXd sizes(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::size_t column = of_stress.columns[static_cast<std::size_t>(k)];
    sizes(k) = of_stress.size[column];
    pull(k) = sizes(k) * weighted_product(d.weight,
                                          std::span(d.jacobian).subspan(column * samples, samples),
                                          std::span(d.by_shift));
  }
  return -error * sizes.cwiseProduct(product(of_stress.inverse, pull).col(0));
}

/// What the errors of the strain where it turns make of the parameters: the sum of the products of
/// what each of them moves.
MatrixXd turn_covariance(const Misfit::Details& d, const StressErrors& of_stress) {
  const auto m = static_cast<Eigen::Index>(of_stress.columns.size());
  const std::size_t samples = d.residual.size();
  MatrixXd pull = MatrixXd::Zero(m, static_cast<Eigen::Index>(d.turns.at.size()));
  VectorXd sizes(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::size_t column = of_stress.columns[static_cast<std::size_t>(k)];
    sizes(k) = of_stress.size[column];
    for (std::size_t turn = 0; turn < d.turns.at.size(); ++turn) {
      const std::size_t end = turn + 1 < d.turns.at.size() ? d.turns.at[turn + 1] : samples;
      double sum = 0.0;
      for (std::size_t s = d.turns.at[turn]; s < end; ++s) {
        sum += d.weight[s] * d.jacobian[column * samples + s] * d.turns.slopes[s];
      }
      pull(k, static_cast<Eigen::Index>(turn)) = d.turns.error * sizes(k) * sum;
    }
  }
  const MatrixXd moved = sizes.asDiagonal() * product(of_stress.inverse, pull);
  return moved * moved.transpose();
}

/// Those samples whose weight is above 0.
class EnteredSamples {
 public:
  explicit EnteredSamples(std::span<const double> weight) {
    entered_.reserve(weight.size());
    for (std::size_t s = 0; s < weight.size(); ++s) {
      if (weight[s] > 0.0) entered_.push_back(s);
    }
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(entered_.size()); }
  /// @param all  a number for each sample
  /// @param to  a column (count)
  void take(std::span<const double> all, Eigen::Ref<VectorXd> to) const {
    double* next = to.data();
    for (const std::size_t s : entered_) *next++ = all[s];
  }
  VectorXd of(std::span<const double> all) const {
    VectorXd taken(count());
    take(all, taken);
    return taken;
  }

 private:
  std::vector<std::size_t> entered_;
};

/// The fit about its solution, its parameters over their sizes.
FitInfluence influence_of(const Misfit::Details& d, const StressErrors& of_stress) {
  const std::size_t samples = d.residual.size();
  const EnteredSamples entered(d.weight);
  const auto m = static_cast<Eigen::Index>(of_stress.columns.size());
  MatrixXd slopes(entered.count(), m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::size_t column = of_stress.columns[static_cast<std::size_t>(k)];
    entered.take(std::span(d.jacobian).subspan(column * samples, samples), slopes.col(k));
    slopes.col(k) *= of_stress.size[column];
  }
  const VectorXd weight = entered.of(d.weight);
  FitInfluence fit;
  // By columns, of which there are a few: their samples stand in a row.
  MatrixXd along(slopes.rows(), m);  // J A^-1
  fit.influence.resize(slopes.rows(), m);
  VectorXd own = VectorXd::Zero(slopes.rows());      // j A^-1 j^T of each sample
  VectorXd squared = VectorXd::Zero(slopes.rows());  // j A^-1 J^T W^2 J A^-1 j^T
  for (Eigen::Index k = 0; k < m; ++k) {
    along.col(k) = of_stress.inverse(0, k) * slopes.col(0);
    for (Eigen::Index i = 1; i < m; ++i) along.col(k) += of_stress.inverse(i, k) * slopes.col(i);
    fit.influence.col(k) = weight.cwiseProduct(along.col(k));
    own += along.col(k).cwiseProduct(slopes.col(k));
  }
  for (Eigen::Index k = 0; k < m; ++k) {
    for (Eigen::Index i = 0; i <= k; ++i) {
      const double times = (i < k ? 2.0 : 1.0) * of_stress.weighted(i, k);
      squared += times * along.col(i).cwiseProduct(along.col(k));
    }
  }
  fit.leverage = weight.cwiseProduct(own);
  fit.left = (1.0 - 2.0 * fit.leverage.array() + squared.array()).matrix();
  fit.residual = entered.of(d.residual);
  if (d.by_shift.empty()) return fit;
  // What the strain's shift is off is no noise of the samples, and counted by itself: it is taken
  // out as a parameter more would.
  const VectorXd shift = entered.of(d.by_shift);
  const VectorXd beside = shift - product(slopes, product(fit.influence.transpose(), shift));
  const VectorXd weighted = weight.cwiseProduct(beside);
  const double size = weighted.dot(beside);
  if (size > 0.0) fit.residual -= weighted.dot(fit.residual) / size * beside;
  return fit;
}

/// Whether residuals are noise, of which alone a variance can be told: not what is left of a curve
/// without any.
bool are_noise(const VectorXd& residual, double largest_stress) {
  constexpr double kNothing = 1e-6;
  const double squares = residual.squaredNorm() / static_cast<double>(residual.size());
  if (!(std::sqrt(squares) > kNothing * largest_stress)) return false;
  const std::span<const double> all(residual.data(), static_cast<std::size_t>(residual.size()));
  return !are_in_runs(runs_test_p(all), autocorrelation(all), static_cast<double>(all.size()));
}

StressErrors stress_errors(const Misfit::Details& d, std::span<const double> active,
                           const ParameterSet& parameters, const Target& target,
                           const FitOptions& options) {
  StressErrors of_stress;
  const std::size_t n = active.size();
  std::vector<double>& size = of_stress.size;
  size.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    size[i] = active[i] != 0.0 ? std::fabs(active[i]) : 1.0;
    if (!parameters.all()[parameters.active()[i]].is_break) of_stress.columns.push_back(i);
  }
  const double stress = largest_magnitude(target.corrected.stress);
  const NormalMatrices normal = keep_identified(d, size, stress, of_stress.columns);
  of_stress.is_determined = normal.is_determined;
  of_stress.has_break = normal.determine(d.permanent_gradient, size);

  const auto m = static_cast<Eigen::Index>(of_stress.columns.size());
  of_stress.covariance = of_stress.of_prior = of_stress.of_stated = of_stress.of_turns =
      MatrixXd::Zero(m, m);
  double squares = 0.0;
  double counted = 0.0;
  for (std::size_t s = 0; s < d.residual.size(); ++s) {
    if (d.weight[s] <= 0.0) continue;
    squares += d.residual[s] * d.residual[s];
    counted += 1.0;
  }
  of_stress.degrees_of_freedom = std::max(1.0, counted - static_cast<double>(m));
  of_stress.variance = squares / of_stress.degrees_of_freedom;
  if (options.objective == Objective::LeastSquares && options.noise) {
    of_stress.variance = *options.noise * *options.noise;
    of_stress.degrees_of_freedom = std::numeric_limits<double>::infinity();
  }
  if (m == 0) return of_stress;
  of_stress.inverse = inverse_of(normal.a);
  of_stress.weighted = normal.b;
  of_stress.prior = between(of_stress.inverse, normal.prior);
  of_stress.stated = between(of_stress.inverse, normal.stated);
  of_stress.stated_in_a = normal.stated_in_a;
  if (!d.by_shift.empty()) of_stress.of_shift = shift_effect(d, target.shift_error, of_stress);
  if (!d.turns.slopes.empty()) of_stress.of_turns = turn_covariance(d, of_stress);
  VectorXd sizes(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    sizes(i) = size[of_stress.columns[static_cast<std::size_t>(i)]];
  }
  of_stress.covariance = scaled(of_stress.variance * between(of_stress.inverse, normal.b), sizes);
  if (!std::isinf(of_stress.degrees_of_freedom)) {
    const FitInfluence fit = influence_of(d, of_stress);
    // The cheap question first: hardly a curve says yes.
    if (is_noise_unequal(fit) && are_noise(fit.residual, stress)) {
      of_stress.own = own_variances(fit);
      of_stress.influence = sizes.asDiagonal() * fit.influence.transpose();
      of_stress.covariance = mapped(of_stress.influence, of_stress.own);
    }
  }
  of_stress.of_prior = scaled(of_stress.prior, sizes);
  of_stress.of_stated = scaled(of_stress.stated, sizes);
  return of_stress;
}

}  // namespace

Uncertainty uncertainty(const Misfit::Details& details, std::span<const double> active,
                        const ParameterSet& parameters, const Target& target,
                        const FitOptions& options, double break_factor) {
  const std::size_t n = active.size();
  const StressErrors of_stress = stress_errors(details, active, parameters, target, options);
  const auto m = static_cast<Eigen::Index>(of_stress.columns.size());

  // Every active parameter as a linear map of the identified stress parameters; the break strain
  // follows the permanent strain at the break.
  MatrixXd map = MatrixXd::Zero(static_cast<Eigen::Index>(n), m);
  VectorXd sampling = VectorXd::Zero(static_cast<Eigen::Index>(n));
  Uncertainty u;
  u.rank = of_stress.columns.size();
  u.identified.assign(n, false);
  u.prior_fraction.assign(n, 0.0);
  for (Eigen::Index k = 0; k < m; ++k) {
    const std::size_t column = of_stress.columns[static_cast<std::size_t>(k)];
    map(static_cast<Eigen::Index>(column), k) = 1.0;
    u.identified[column] = of_stress.is_determined[static_cast<std::size_t>(k)];
    u.prior_fraction[column] = of_stress.stated_in_a(k) * of_stress.inverse(k, k);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!parameters.all()[parameters.active()[i]].is_break) continue;
    u.identified[i] = of_stress.has_break;
    const auto row = static_cast<Eigen::Index>(i);
    for (Eigen::Index k = 0; k < m; ++k) {
      map(row, k) =
          details.permanent_gradient[of_stress.columns[static_cast<std::size_t>(k)]] / break_factor;
    }
    sampling(row) = target.characteristics.observed_break->half_interval() / break_factor;
  }
  const MatrixXd of_residuals = mapped(map, of_stress.covariance);
  const MatrixXd of_prior = mapped(map, of_stress.of_prior);
  const MatrixXd of_stated = mapped(map, of_stress.of_stated);
  const MatrixXd of_turns = mapped(map, of_stress.of_turns);
  VectorXd of_shift = VectorXd::Zero(static_cast<Eigen::Index>(n));
  if (of_stress.of_shift.size() > 0) of_shift = product(map, of_stress.of_shift);
  if (target.shift_error > 0.0) {
    for (std::size_t i = 0; i < n; ++i) {
      // The strain at the break lies where the others do.
      if (!parameters.all()[parameters.active()[i]].is_break) continue;
      of_shift(static_cast<Eigen::Index>(i)) -= target.shift_error / break_factor;
    }
  }
  const MatrixXd covariance =
      of_residuals + of_prior + of_stated + of_turns + product(of_shift, of_shift.transpose());
  u.standard_error.assign(n, kNan);
  u.noise_error.assign(n, kNan);
  u.residual_error.assign(n, kNan);
  u.sampling.assign(n, 0.0);
  u.correlation.assign(n * n, kNan);
  for (std::size_t i = 0; i < n; ++i) {
    if (!u.identified[i]) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const double half = std::fabs(sampling(row));
    u.residual_error[i] = std::sqrt(std::max(0.0, of_residuals(row, row)));
    const double of_curve = u.residual_error[i] + std::sqrt(std::max(0.0, of_prior(row, row)));
    const double beside = std::max(0.0, of_stated(row, row)) + std::max(0.0, of_turns(row, row));
    u.noise_error[i] = std::hypot(of_curve, of_shift(row), std::sqrt(beside));
    u.sampling[i] = half;
    u.standard_error[i] = std::hypot(u.noise_error[i], half / std::sqrt(3.0));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      if (!u.identified[i] || !u.identified[j]) continue;
      const double product = u.standard_error[i] * u.standard_error[j];
      const double c = covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      u.correlation[i * n + j] = i == j ? 1.0 : product > 0.0 ? c / product : 0.0;
    }
  }
  u.noise = std::sqrt(of_stress.variance);
  u.degrees_of_freedom.assign(n, of_stress.degrees_of_freedom);
  if (of_stress.own.size() > 0) {
    u.own_variance.assign(of_stress.own.data(), of_stress.own.data() + of_stress.own.size());
    const MatrixXd influence = product(map, of_stress.influence);
    for (std::size_t i = 0; i < n; ++i) {
      u.degrees_of_freedom[i] =
          degrees_of_own(influence.row(static_cast<Eigen::Index>(i)).cwiseAbs2().transpose(),
                         of_stress.own, of_stress.degrees_of_freedom);
    }
  }
  return u;
}

Spread spread_of(const Misfit::Details& details, std::span<const double> active,
                 const ParameterSet& parameters, const Target& target, const FitOptions& options) {
  const StressErrors of_stress = stress_errors(details, active, parameters, target, options);
  const std::size_t n = active.size();
  Spread all;
  all.inverse.assign(n * n, kNan);
  all.spread.assign(n * n, kNan);
  all.prior.assign(n * n, kNan);
  all.stated.assign(n * n, kNan);
  if (of_stress.columns.empty()) return all;
  const MatrixXd spread = between(of_stress.inverse, of_stress.weighted);
  for (std::size_t i = 0; i < of_stress.columns.size(); ++i) {
    for (std::size_t j = 0; j < of_stress.columns.size(); ++j) {
      if (!of_stress.is_determined[i] || !of_stress.is_determined[j]) continue;
      const std::size_t a = of_stress.columns[i], b = of_stress.columns[j];
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      const double unit = of_stress.size[a] * of_stress.size[b];
      all.inverse[a * n + b] = unit * of_stress.inverse(row, column);
      all.spread[a * n + b] = of_stress.own.size() > 0
                                  ? of_stress.covariance(row, column) / of_stress.variance
                                  : unit * spread(row, column);
      all.prior[a * n + b] = unit * of_stress.prior(row, column);
      all.stated[a * n + b] = unit * of_stress.stated(row, column);
    }
  }
  return all;
}

}  // namespace plastica::calibrate
