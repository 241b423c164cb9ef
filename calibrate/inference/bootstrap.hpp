#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "calibrate/search/least_squares.hpp"

namespace plastica::calibrate {

/// Random numbers of one resample: a seed and its index give the same on every machine, whatever
/// the others draw. Source: Steele, Lea & Flood, OOPSLA 2014, 453 (splitmix).
class Draws {
 public:
  Draws(std::uint64_t seed, std::uint64_t index);

  std::uint64_t bits();
  double uniform();                      ///< within (0, 1)
  double normal();                       ///< mean 0, variance 1
  std::size_t below(std::size_t count);  ///< 0 … count - 1

 private:
  std::uint64_t state_;
};

/// Residuals resampled with replacement, by blocks of neighbours that go on from the last residual
/// to the first. Centred before, so that each has the mean 0.
/// Source: Efron, Ann. Stat. 7 (1979) 1; blocks: Politis & Romano, in: Exploring the Limits of
/// Bootstrap, 1992, 263.
/// @param inflation  of the centred ones, such as sqrt(m/(m - n)) for what n parameters took
/// @param block  length of a block, >= 1; 1 where residuals are independent
std::vector<double> drawn_residuals(std::span<const double> residual, double inflation,
                                    std::size_t block, Draws& draws);

/// A problem with the residuals factor_i (r_i + shift_i).
/// @param problem  must outlive it
/// @param factor, shift  (m)
LeastSquaresProblem changed(const LeastSquaresProblem& problem, std::vector<double> factor,
                            std::vector<double> shift);

/// What resamples say of a number.
struct BootstrapInterval {
  double standard_error = 0.0;   ///< standard deviation of the values, with B - 1
  double low = 0.0, high = 0.0;  ///< percentiles
};

/// The percentile interval: of B values in rising order those of the numbers (B + 1)(1 -
/// confidence)/2 and (B + 1)(1 + confidence)/2, on a straight line between two of them.
/// Source: Davison & Hinkley, Bootstrap Methods and their Application, 1997, 5.3.
/// @param values  (B); of fewer than 2 all is NaN
BootstrapInterval bootstrap_interval(std::vector<double> values, double confidence);

}  // namespace plastica::calibrate
