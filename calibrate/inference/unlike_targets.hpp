#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// Targets of one kind that share the parameters of a fit: specimens, most often.
///
/// At the shared solution target t has residuals r_t and slopes J_t (over noise and weights), the
/// score g_t = J_t^T r_t and A_t = J_t^T J_t. By itself it would go on by d_t = -A_t^-1 g_t; the
/// kind by d = -(sum A_t/v_t)^-1 sum g_t/v_t, v_t what its noise counts. With h_t = g_t + A_t d and
/// V_t the covariance of the score by noise, of what is left at d_t, so that a difference is not
/// taken for it (as of independent samples, times (1 + rho)/(1 - rho) where neighbours are alike),
///   chi^2 = sum h_t^T V_t^-1 h_t
/// is chi-squared of sum rank A_t - rank sum A_t degrees of freedom if all ask for the same; each
/// term is first made as seldom by chi-squared as it is by F, V_t being an estimate. Targets whose
/// samples are worth few degrees of freedom are not in it.
///
/// Of specimens that are drawn from many, the scores scatter by their difference, too:
///   (n - 1)/n sum k_t k_t^T,  k_t = (1 - A_t (sum A)^-1)^-1 h_t,
/// with n - 1 degrees of freedom, is the covariance of their sum: the sandwich by groups (Liang &
/// Zeger, Biometrika 73 (1986) 13) as a jackknife, which sees through a target that pulls the
/// solution to itself (CR3: Bell & McCaffrey, Survey Methodology 28 (2002) 169). Of targets that
/// count alike it is n/(n - 1) sum h_t h_t^T.
struct TargetsOfOneKind {
  std::vector<std::size_t> targets;
  double chi_squared = 0.0;
  double degrees = 0.0;  ///< of freedom; 0: nothing to compare
  /// What is left of each one's residuals at d_t, over noise and weights (targets, n_samples).
  std::vector<Eigen::VectorXd> left;
  std::vector<double> degrees_left;  ///< of freedom, of these (targets)
  /// By what the scales of each are to be multiplied so that all count alike in the solution, and
  /// that what they differ by is as much as noise would make (targets).
  std::vector<double> to_count_alike;
  /// Of the sum of the scores, of coordinates that are free, in their order (n_free x n_free).
  Eigen::MatrixXd scores;

  /// That their noise alone makes them differ by as much.
  double probability() const;
  /// Whether they differ by more than their noise does once in a thousand times: that is said.
  bool differ() const { return probability() < 1e-3; }
  /// Whether they may well differ, so that they count as if they did: a difference that is not seen
  /// for sure makes the errors of the noise too small all the same.
  bool may_differ() const { return probability() < 0.1; }
  /// Whether their scatter tells the error of what they share: of three and more.
  bool tell_scatter() const { return targets.size() > 2 && may_differ(); }
};

/// All kinds that several targets are of (`are_of_one_kind`).
/// @param slopes    d residual / d coordinate, row by row (n_residuals x n)
/// @param residual  at the solution (n_residuals)
/// @param free      the coordinates that the curves determine
std::vector<TargetsOfOneKind> targets_of_one_kind(const SceneProblem& problem,
                                                  std::span<const double> slopes,
                                                  std::span<const double> residual,
                                                  const std::vector<Eigen::Index>& free);

/// What is left at d_t of the k-th target of a kind: model - measured [SI] (n_samples).
/// @param kind  found with the scales that the problem has
std::vector<double> left_alone(const SceneProblem& problem, const TargetsOfOneKind& kind,
                               std::size_t k);

}  // namespace plastica::calibrate
