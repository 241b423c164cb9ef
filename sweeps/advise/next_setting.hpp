#pragma once

#include <string>
#include <vector>

#include "sweeps/advise/discretization.hpp"

/// From errors of a setting to the next one to try; not installed.
namespace plastica::sweeps {

/// What one axis adds to the error of a setting.
struct AxisError {
  double change = 0.0;  ///< of the result when the axis is made finer alone [1]; may be infinite
  double ratio = 2.0;   ///< size over the finer size, > 1
  double order = 1.0;   ///< with which the error falls along the axis [1]
  double error = 0.0;   ///< change/(1 - ratio^-order): what is left down to the limit [1]
  bool seen = false;    ///< whether the order was seen, and not supposed
  /// What is left at most of a quantity whose changes have another sign than before, or fall faster
  /// than any method's order: errors of unlike orders may cancel, and the change is small by that
  /// [1].
  double hidden = 0.0;
  std::string quantity{};  ///< whose change it is
};

/// An error that falls as size^order: what a step to a finer size leaves of it down to the limit.
/// f(h) - f(0) = a h^p, so f(h) - f(h/r) = a h^p (1 - r^-p).
double left_of(double change, double ratio, double order);

/// The order that two changes of one axis show, kept within 0.5 … `highest`: a change that does not
/// fall is no order at all.
/// @param size, change  of the coarser and of the finer setting
double seen_order(double coarse_size, double coarse_change, double fine_size, double fine_change,
                  double highest);

/// The setting whose errors come to `wanted` at the least cost, if each falls with its order.
///
/// The cost is supposed to grow as the product of the axes' counts, prod 1/h_k. Its least under
/// sum e_k (h_k'/h_k)^p_k = wanted has shares wanted/p_k/sum(1/p_j): the derivative of ln cost,
/// -1/h_k, is then the same multiple of the derivative of the sum, p_k e_k'/h_k, on each axis.
/// Axes whose error is below a thousandth of `wanted` have no share and become coarser. No size
/// changes by more than an eighth or two at once: orders hold near where they were seen.
/// An axis whose change is infinite is halved.
Setting next_setting(const std::vector<FinenessAxis>& axes, const Setting& setting,
                     const std::vector<AxisError>& errors, double wanted);

}  // namespace plastica::sweeps
