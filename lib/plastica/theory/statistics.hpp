#pragma once

#include <span>

namespace plastica::theory {

/// Probability that a standard normal variable is below x.
double normal_cdf(double x);

/// Inverse of normal_cdf; relative error below 1e-12 for probabilities down to 1e-300.
/// @param probability  0 < p < 1
double normal_quantile(double probability);

/// Probability that a Student t variable is below t.
///
/// By the regularized incomplete beta function; relative error below 1e-9 in the lower tail.
/// @param degrees_of_freedom  nu > 0, not necessarily an integer; up to 1e4
double student_t_cdf(double t, double degrees_of_freedom);

/// Inverse of student_t_cdf; error below 1e-8 of the value. From 200 degrees of freedom on, unless
/// the tail is so thin that z^2 > 0.11 nu, by the Cornish-Fisher expansion about the normal
/// quantile z (Abramowitz & Stegun 26.7.5; 2e-9 off at most, against bisection).
/// @param probability         0 < p < 1
/// @param degrees_of_freedom  nu > 0; infinity gives the normal quantile
double student_t_quantile(double probability, double degrees_of_freedom);

/// Probability that a chi-squared variable is below x, by the regularized incomplete gamma function
/// (Eigen's).
/// @param degrees_of_freedom  k > 0, not necessarily an integer
double chi_squared_cdf(double x, double degrees_of_freedom);

/// Inverse of chi_squared_cdf; error below 1e-9 of the value.
/// @param probability  0 < p < 1
double chi_squared_quantile(double probability, double degrees_of_freedom);

/// The q within which (|x| <= q) an error x = scale t + sum h_k u_k lies with the given confidence:
/// t a Student t variable, u_k uniform within -1 … 1, all independent. So is a measured value of
/// which noise is one part and the distance between samples the other. With one h and more than one
/// degree of freedom to 1e-9, by the integral of the distribution function; else to 5e-4 of q + sum
/// h_k, by its averages over 2 h_k on a grid, one after the other.
/// @param confidence          within (0, 1)
/// @param scale               >= 0
/// @param degrees_of_freedom  of t, > 0; infinity: normal
/// @param halves              h_k >= 0
double half_interval(double confidence, double scale, double degrees_of_freedom,
                     std::span<const double> halves);

}  // namespace plastica::theory
