#pragma once

#include <span>
#include <vector>

namespace plastica::calibrate {

/// Covariance of the sum of the scores s_i = j_i r_i of residuals that need not be independent:
///
///   sum over lags l = -L … L of (1 - |l|/(L + 1)) sum_i z_i z_{i+|l|}^T / (1 - rho)^2
///
/// (Newey & West, Econometrica 55 (1987) 703) of z_i = s_i - rho s_{i-1}, which are nearly
/// independent where the residuals are those of an autoregressive process: of the scores themselves
/// the sum comes out too small in a curve of few samples, by half for rho = 0.5 and 80 of them
/// (Andrews & Monahan, Econometrica 60 (1992) 953). rho is the correlation of neighbouring
/// residuals, within [0, 0.97]; where it is positive, what a fit of k parameters has taken from it
/// is added, (k (1 + rho) + 2 rho)/n (for none and for a mean alone after Kendall, Biometrika 41
/// (1954) 403). L = 1.1447 (a n)^(1/3), a = 4 rho'^2/(1 - rho'^2)^2 and rho' the correlation that
/// is left in r_i - rho r_{i-1} (Andrews, Econometrica 59 (1991) 817, eq. 6.2 and 6.4), n - 1 at
/// most. For independent residuals of unit variance it tends to J^T J. Divided by A = J^T J from
/// both sides it is the covariance of a least-squares solution whose model does not follow the
/// curve, as far as the curve can say it.
/// @param slopes    d residual / d parameter (n x n_parameters), row by row
/// @param residual  in the order of the path (n >= 1)
/// @return (n_parameters x n_parameters), row by row
std::vector<double> score_covariance(std::span<const double> slopes,
                                     std::span<const double> residual);

}  // namespace plastica::calibrate
