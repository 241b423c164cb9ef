#include "sweeps/advise/axis_models.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plastica/theory/convergence.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kSupposedOrder = 1.0;
/// Sizes that differ by less show no order.
constexpr double kLeastRatio = 1.3;
constexpr double kSameError = 1.1;

/// Whether changes are of one sign, and fall as an order does that a method may have.
/// @param ratio  size of the coarser over that of the finer change, > 1
bool falls_in_order(double coarse, double fine, double ratio) {
  if (coarse == 0.0 && fine == 0.0) return true;
  return std::abs(coarse) <= std::pow(ratio, theory::kHighestOrder + theory::kBeyondHighestOrder) *
                                 std::abs(fine) &&
         (coarse > 0.0) == (fine > 0.0);
}

/// What changes of some quantity may hide: of a h + b h^2 that is halved twice the error at h is
/// 8/3 of the finer change less 1/3 of the coarser one, and of other ratios about as much.
double hidden_by(const std::vector<SignedDeviation>& coarse,
                 const std::vector<SignedDeviation>& fine, double ratio) {
  double hidden = 0.0;
  if (coarse.size() != fine.size()) return hidden;
  for (std::size_t q = 0; q < fine.size(); ++q) {
    const double before = coarse[q].value;
    const double now = fine[q].value;
    const bool known = std::isfinite(before) && std::isfinite(now);
    if (!known || falls_in_order(before, now, ratio)) continue;
    hidden = std::max(hidden, (8.0 * std::abs(now) + std::abs(before)) / 3.0);
  }
  return hidden;
}

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
    const bool apart = ratio > kLeastRatio || ratio < 1.0 / kLeastRatio;
    if (apart && std::isfinite(change)) {
      const double hidden = ratio > 1.0 ? hidden_by(before.parts, off.parts, ratio)
                                        : hidden_by(off.parts, before.parts, 1.0 / ratio);
      error.hidden = std::max(error.hidden, hidden);
    }
    const bool tells = apart && before.error.change > 0.0 && change > 0.0 && std::isfinite(change);
    if (!tells) continue;
    error.order = seen_order(before.size, before.error.change, size, change, theory::kHighestOrder);
    error.seen = true;
  }
  error.error = left_of(error.change, error.ratio, error.order);
  if (std::isfinite(change)) {
    seen_[axis].push_back({size, error, off.quantities, off.parts});
    known_[axis] = true;
    most_quantities_ = std::max(most_quantities_, off.quantities);
  }
  return error;
}

AxisError AxisModels::measured_twice(std::size_t axis, double size, double finer_size,
                                     double finest_size, const Deviation& off,
                                     const Deviation& finer_off) {
  AxisError error;
  error.quantity = off.quantity;
  const double ratio = size / finer_size;
  const bool falls = finer_off.largest > 0.0;
  error.change = std::max(off.largest, finer_off.largest);
  error.hidden = 0.0;
  error.seen = true;
  error.order =
      falls ? seen_order(size, off.largest, finer_size, finer_off.largest, theory::kHighestOrder)
            : theory::kHighestOrder;
  error.error = left_of(error.change, ratio, error.order);
  if (!std::isfinite(error.change)) return error;
  const SignedDeviation both =
      off_limit_of_two_orders({finest_size, finer_size, size}, off, finer_off);
  if (std::abs(both.value) > error.error) {
    // The order of the term that is left in the end, unless both say nearly the same.
    if (std::abs(both.value) > kSameError * error.error) error.order = kSupposedOrder;
    error.error = std::abs(both.value);
    error.quantity = both.quantity;
  }
  error.ratio = ratio;
  // Of this size the last that is seen.
  std::erase_if(seen_[axis], [&](const Seen& one) { return one.size == size; });
  seen_[axis].push_back({size, error, off.quantities, off.parts});
  return error;
}

AxisError AxisModels::foretold(std::size_t axis, double size) const {
  const Seen& last = seen_[axis].back();
  AxisError error = last.error;
  const double ratio = size / last.size;
  const double order = error.seen    ? error.order
                       : ratio > 1.0 ? theory::kHighestOrder
                                     : kSupposedOrder;
  const double factor = std::pow(ratio, order);
  error.change *= factor;
  error.hidden *= factor;
  error.error *= factor;
  return error;
}

}  // namespace plastica::sweeps
