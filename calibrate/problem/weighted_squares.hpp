#pragma once

#include <cstddef>
#include <span>

namespace plastica::calibrate {

/// sum w_i (m_i - t_i)^2 of a model's values and a target's (n).
///
/// Sums of a fixed order: four of every fourth sample, so that none waits for the one before.
double weighted_squares(std::span<const double> model, std::span<const double> target,
                        std::span<const double> weight);

/// The same, with its derivatives 2 sum w_i (m_i - t_i) dm_i/dp in `gradient` (n_parameters).
/// @param slopes  dm_i/dp (n x n_parameters), row by row
double weighted_squares(std::span<const double> model, std::span<const double> target,
                        std::span<const double> weight, std::span<const double> slopes,
                        std::span<double> gradient);

/// sum w_i (dm_i/dp) (dm_i/dq) in `normal` (n_parameters x n_parameters), sums of a fixed order.
/// @param slopes  dm_i/dp (n x n_parameters), row by row
void weighted_normal(std::span<const double> weight, std::span<const double> slopes,
                     std::size_t parameters, std::span<double> normal);

/// sum w_i a_i b_i (n); sums of a fixed order, as above.
double weighted_product(std::span<const double> weight, std::span<const double> a,
                        std::span<const double> b);

/// sum w_i a_i b_i and sum w_i^2 a_i b_i.
struct TwiceWeighted {
  double once = 0.0, twice = 0.0;
};
/// Both of these (n); sums of a fixed order, as above.
TwiceWeighted twice_weighted_product(std::span<const double> weight, std::span<const double> a,
                                     std::span<const double> b);

}  // namespace plastica::calibrate
