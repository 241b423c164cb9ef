#include "sweeps/advise/axis_models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plastica::sweeps {
namespace {

constexpr double kSupposedOrder = 1.0;
constexpr double kHighestOrder = 2.0;
/// Sizes that differ by less show no order.
constexpr double kLeastRatio = 1.3;

}  // namespace

AxisError AxisModels::measured(std::size_t axis, double size, double finer_size,
                               const Deviation& off) {
  const double change = off.largest;
  AxisError error;
  error.quantity = off.quantity;
  error.ratio = size / finer_size;
  if (!(error.ratio > 1.0)) {  // it is at its finest, and nothing says what it is off
    error.change = error.error = std::numeric_limits<double>::infinity();
    return error;
  }
  error.change = change;
  error.order = kSupposedOrder;
  for (const Seen& before : seen_[axis]) {
    const double ratio = before.size / size;
    const bool tells = (ratio > kLeastRatio || ratio < 1.0 / kLeastRatio) &&
                       before.error.change > 0.0 && change > 0.0 && std::isfinite(change);
    if (!tells) continue;
    error.order = seen_order(before.size, before.error.change, size, change, kHighestOrder);
    error.seen = true;
  }
  error.error = left_of(error.change, error.ratio, error.order);
  if (std::isfinite(change)) {
    seen_[axis].push_back({size, error, off.quantities});
    known_[axis] = true;
    most_quantities_ = std::max(most_quantities_, off.quantities);
  }
  return error;
}

AxisError AxisModels::foretold(std::size_t axis, double size) const {
  const Seen& last = seen_[axis].back();
  AxisError error = last.error;
  const double ratio = size / last.size;
  const double order = error.seen ? error.order : ratio > 1.0 ? kHighestOrder : kSupposedOrder;
  const double factor = std::pow(ratio, order);
  error.change *= factor;
  error.error *= factor;
  return error;
}

}  // namespace plastica::sweeps
