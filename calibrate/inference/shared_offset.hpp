#pragma once

#include <span>

namespace plastica::calibrate {

/// A constant that all ordinates of a curve have too much, as of a sensor that was set to zero
/// under load, as far as the residuals show it.
struct SharedOffset {
  double value = 0.0;       ///< what to take off the measured ordinates, in residuals of weight 1
  double of_squares = 0.0;  ///< fraction of the squared residuals that it explains [0, 1]
  double errors = 0.0;      ///< its size over its standard error (Student's t)

  /// Whether it is no noise, and more than a small part of what is left.
  bool stands_out() const { return errors > 4.0 && of_squares > 0.25; }
};

/// The score test of a constant beside the fitted parameters: with u what the slopes leave of a
/// vector of ones and r what they leave of the residuals, the constant is -u.r/u.u, and the squares
/// fall by (u.r)^2/u.u (added-variable regression; Cook & Weisberg, Residuals and Influence in
/// Regression (1982), 2.3). Of a constant that the parameters make up for it finds nothing.
/// @param slopes    d residual / d parameter (n x n_parameters), row by row
/// @param residual  fitted minus measured, times the root of its weight (n)
/// @param weights   (n); empty: all 1. The vector of ones is one of their roots
SharedOffset shared_offset(std::span<const double> slopes, std::span<const double> residual,
                           std::span<const double> weights = {});

}  // namespace plastica::calibrate
