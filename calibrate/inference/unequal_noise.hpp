#pragma once

#include <Eigen/Core>

/// Noise that is not alike on all samples of a curve; not installed.
namespace plastica::calibrate {

/// A linearized weighted fit, of the samples that enter it (n) and the parameters that they
/// determine (m). With the residuals' Jacobian J, weights W and A = J^T W J (a prior's curvature
/// included) the parameters move by -A^-1 J^T W e with errors e of the samples.
struct FitInfluence {
  Eigen::MatrixXd influence;  ///< W J A^-1, a row for each sample (n x m)
  Eigen::VectorXd leverage;   ///< h_i = w_i j_i^T A^-1 j_i (n)
  /// m_i = 1 - 2 h_i + j_i^T A^-1 J^T W^2 J A^-1 j_i, what the fit leaves of the variance of a
  /// residual where that of all samples is one (n); 1 - h_i of equal weights.
  Eigen::VectorXd left;
  Eigen::VectorXd residual;  ///< (n)
};

/// Whether the samples that decide on a parameter scatter otherwise than the rest, as noise of the
/// strain makes them: on the elastic part it is E times as much noise of the stress, where a curve
/// is flat next to none.
///
/// For each parameter the mean of r_i^2/m_i, weighted by the squares of its influences over the
/// largest one, c_i, is compared with that weighted by 1 - c_i: their ratio is F-distributed if the
/// noise is equal, each with (sum c)^2/sum c^2 degrees of freedom (Satterthwaite, Biometrics
/// Bulletin 2 (1946) 110). Unequal: beyond the two-sided 1 %, shared out among the parameters
/// (Bonferroni). The F quantile is Paulson's, Ann. Math. Stat. 13 (1942) 233.
bool is_noise_unequal(const FitInfluence& fit);

/// What the residuals say of the variance of each sample, r_i^2/(m_i (1 - h_i)) (n): with it the
/// covariance of the parameters is the sandwich influence^T diag(v) influence. Of equal weights it
/// is HC3 of MacKinnon & White, J. Econometrics 29 (1985) 305.
Eigen::VectorXd own_variances(const FitInfluence& fit);

/// Degrees of freedom of a variance that is such a sum, s = sum c_i v_i with the squared influences
/// c_i: s^2/(sum c_i^2 v_i^2/3), for a normal residual's fourth moment is 3 of its squared variance
/// (Satterthwaite); no less than 2.
/// @param most  no more than these
double degrees_of_own(const Eigen::VectorXd& squared_influence, const Eigen::VectorXd& variance,
                      double most);

}  // namespace plastica::calibrate
