#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calibrate/inference/identifiable_slopes.hpp"
#include "calibrate/inference/unlike_targets.hpp"
#include "calibrate/problem/scene_problem.hpp"

namespace plastica::calibrate {

/// A break limit as the fitted scenes have it.
struct BreakLimit {
  double value = 0.0;  ///< [1]; NaN if no scene gets there
  /// Half the intervals that the samplings of all targets leave, times their fractions [1].
  std::vector<double> halves;
  Eigen::VectorXd slope;  ///< by the coordinates (n)
  /// Of several targets: the smallest and the largest, and whether any is further from the mean
  /// than four of its standard errors.
  double min = 0.0, max = 0.0;
  bool disagree = false;
  /// Of three and more that disagree: the mean's standard error by how they scatter [1], and its
  /// degrees of freedom; else 0.
  double scatter = 0.0, scatter_degrees = 0.0;
  /// What each target counts in the value, 0 if it did not break in its way (n_targets).
  std::vector<double> fractions;

  double half() const;  ///< the sum of the halves
};

/// The limit that is half way between a strain that held and one that broke [1].
/// @param ends  whether the path ends before the beam was broken for sure: what lies beyond is then
///        taken to be as wide as what lies before
double limit_within(const StrainAtBreak& strain, bool ends);

/// a^T C b over the coordinates that both have anything of: what C does not know of others does not
/// count.
double joint_moment(const Eigen::MatrixXd& c, const Eigen::VectorXd& a, const Eigen::VectorXd& b);

/// What the curves say of the coordinates at a solution, and of the break limits.
class SceneErrors {
 public:
  /// @param x  coordinates of the solution (n)
  /// @param residual  there, over the scales
  /// @param confidence  with which a yield stress must be bounded from above (unbounded_yield.hpp);
  ///                    empty: as where the scales are not the noise, it is not asked
  SceneErrors(SceneProblem& problem, std::span<const double> x, std::span<const double> residual,
              std::optional<double> confidence = {});

  const IdentifiableSlopes& identifiable() const { return identifiable_; }
  /// d residual / d coordinate, over the scales, row by row (n_residuals x n).
  std::span<const double> slopes() const { return slopes_; }
  bool at_bound(std::size_t i) const { return at_bound_[i]; }
  // Directions that no curve shows have a coordinate each that is held, with zeros below. What is
  // asked of functions of the coordinates goes through `moment`, which knows whether the curves
  // determine them.
  /// Covariance of the coordinates; NaN in rows and columns of those that move nothing, or are at a
  /// bound (n x n).
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// The same for residuals that lie in runs (score_covariance.hpp), and for targets that differ
  /// (`TargetsOfOneKind::tell_scatter`) (n x n).
  const Eigen::MatrixXd& correlated_covariance() const { return correlated_covariance_; }
  /// Those that several targets are of.
  const std::vector<TargetsOfOneKind>& kinds() const { return kinds_; }
  /// Whether targets that differ are in the correlated covariance.
  bool has_scatter() const { return !scatter_.empty(); }
  /// As `degrees_of_freedom`, of the correlated covariance.
  double correlated_degrees(const Eigen::VectorXd& gradient) const;
  /// The inverse of J^T W J, likewise: the covariance if all weights are 1 (n x n).
  const Eigen::MatrixXd& inverse() const { return inverse_; }
  /// `joint_moment` of one of these; NaN where the curves do not determine both functions, whose
  /// gradients are given (n).
  double moment(const Eigen::MatrixXd& of, const Eigen::VectorXd& a,
                const Eigen::VectorXd& b) const;
  /// Of the noise in a function of the coordinates, by Welch and Satterthwaite: (sum of v)^2 over
  /// the sum of v^2/d, with v what the noise of each estimate puts into the variance and d its
  /// degrees of freedom. Infinite where all noise is known.
  /// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110.
  /// @param gradient  by the coordinates (n)
  double degrees_of_freedom(const Eigen::VectorXd& gradient) const;
  /// Standard errors of a target's fitted ordinates, by what its curves determine [SI] (n_samples).
  std::vector<double> fitted_errors(std::size_t t) const;

  /// The limit of one break parameter, by all targets that broke in its way.
  BreakLimit break_limit(const Parameter& p);

 private:
  /// Sets the slopes by the others to those where it does not act.
  void take_out_unbounded_yield(std::span<const double> residual, double confidence);
  void set_covariance(std::span<const double> residual, std::optional<double> confidence);
  Eigen::MatrixXd correlated_scores(std::span<const double> residual,
                                    const std::vector<Eigen::Index>& free) const;
  std::vector<Eigen::Index> hold_unseen(const Eigen::MatrixXd& normal,
                                        const std::vector<Eigen::Index>& kept);
  bool determines(const Eigen::VectorXd& gradient) const;
  Eigen::VectorXd weights() const;
  /// The break strains at the solution and on both sides of it in each coordinate, by target.
  void run_neighbours();
  BreakLimit limit_of(std::size_t t) const;

  SceneProblem& problem_;
  std::vector<double> x_;
  std::vector<bool> at_bound_;
  Eigen::MatrixXd covariance_, inverse_;
  Eigen::MatrixXd correlated_covariance_;
  Eigen::MatrixXd unseen_;  ///< directions that no curve shows, over `unit_` (n x directions)
  Eigen::VectorXd unit_;    ///< of the coordinates (n)
  std::vector<TargetsOfOneKind> kinds_;
  /// What targets that differ put into the correlated covariance.
  struct Scatter {
    Eigen::MatrixXd covariance;  ///< (n x n)
    double degrees = 0.0;        ///< of freedom
  };
  std::vector<Scatter> scatter_;
  std::vector<Eigen::MatrixXd> by_target_;  ///< what each target's noise puts into the covariance
  std::vector<double> slopes_;              ///< of the residuals (m x n), row by row
  IdentifiableSlopes identifiable_;
  std::vector<std::vector<SceneCurve>> neighbours_;
};

/// Whether a break limit, in tension or in torsion, is one of a target's scene.
bool limits(MaterialField limit, const SceneModel& model, const WeightedTarget& weighted);
/// Whether a target broke in the way that a break parameter limits.
bool breaks_by(const Parameter& p, const SceneModel& model, const WeightedTarget& weighted);

}  // namespace plastica::calibrate
