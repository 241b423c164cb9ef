#pragma once

namespace plastica::theory {

/// Probability that a standard normal variable is below x.
double normal_cdf(double x);

/// Inverse of normal_cdf; relative error below 1e-12 for probabilities down to 1e-300.
/// @param probability  0 < p < 1
double normal_quantile(double probability);

/// Probability that a Student t variable is below t.
///
/// By the regularized incomplete beta function; relative error below 1e-9 in the lower tail.
/// @param degrees_of_freedom  nu > 0, not necessarily whole; up to 1e4
double student_t_cdf(double t, double degrees_of_freedom);

/// Inverse of student_t_cdf; error below 1e-8 of the value. Beyond 1e4 degrees of freedom by the
/// Cornish-Fisher expansion about the normal quantile (Abramowitz & Stegun 26.7.5).
/// @param probability         0 < p < 1
/// @param degrees_of_freedom  nu > 0; infinity gives the normal quantile
double student_t_quantile(double probability, double degrees_of_freedom);

}  // namespace plastica::theory
