#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// Of a normal matrix scaled to a unit diagonal: a direction along an eigenvector whose eigenvalue
/// is below this is not identifiable, since no curve depends on it.
inline constexpr double kNotIdentifiable = 1e-12;

/// The slopes of the residuals by the coordinates that are not at a bound, and which directions of
/// these are identifiable.
class IdentifiableSlopes {
 public:
  IdentifiableSlopes() = default;
  /// @param slopes  d residual / d coordinate (m x n), row by row
  /// @param at_bound  coordinates that are held there (n)
  IdentifiableSlopes(std::span<const double> slopes, const std::vector<bool>& at_bound);

  /// Of the coordinates that move any residual (m x n_moving).
  const Eigen::MatrixXd& slopes() const { return slopes_; }
  /// The inverse of J^T J over the identifiable directions, 0 along the others (n_moving x
  /// n_moving).
  const Eigen::MatrixXd& inverse() const { return inverse_; }

 private:
  Eigen::MatrixXd slopes_, inverse_;
};

/// Degrees of freedom that a fit leaves to the residuals of each target.
///
/// With H = J (J^T J)^-1 J^T the residuals of the solution are (1 - H) e, e the errors over the
/// scales times the root of the weights. If each target's scale is its noise, the expected sum of
/// squares of target p, each over the weight of its sample, is
///
///   m_p - 2 sum of H_ii over i of p + sum of (w_j/w_i) H_ij^2 over i of p and all j
///
/// for equal weights m_p less the trace of H over p. A prior is a target of its own, of weight 1. A
/// target that determines a parameter by itself loses one, one beside which others determine it far
/// better loses none.
/// @param problem  its weights count
/// @return (n_targets), >= 0
std::vector<double> degrees_left(const SceneProblem& problem, const IdentifiableSlopes& slopes);

}  // namespace plastica::calibrate
