#include "calibrate/inference/segments_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "plastica/theory/convergence.hpp"

namespace plastica::calibrate {
namespace {

/// A fit finds its values to this fraction of them.
constexpr double kSettled = 1e-6;
/// Below it an extrapolation goes further than all values together.
constexpr double kMinOrder = 0.5;
/// So far beyond the joints' order the coarsest value is not in line with the others.
constexpr double kBeyond = 1.0;
constexpr double kSafe = 1.25;
constexpr double kUnsafe = 3.0;

struct Value {
  double size = 0.0;  ///< of a segment, over that of N
  double value = 0.0;
};

void set_by_spread(double spread, SegmentsError& error) {
  error.safety_factor = kUnsafe;
  error.error = error.extrapolated_error = kUnsafe * spread;
}

}  // namespace

std::string_view name_of(SegmentsTrend trend) {
  switch (trend) {
    case SegmentsTrend::Unknown: return "unknown";
    case SegmentsTrend::Settled: return "settled";
    case SegmentsTrend::Monotone: return "monotone";
    case SegmentsTrend::Assumed: return "assumed";
    case SegmentsTrend::Oscillates: return "oscillates";
    case SegmentsTrend::Diverges: return "diverges";
  }
  return "";
}

SegmentsError segments_error(double at_half, double at_own, double at_twice, double joints_order) {
  SegmentsError error;
  error.at_half = at_half;
  error.at_own = at_own;
  error.at_twice = at_twice;
  std::vector<double> sizes, values;  // the finest first
  for (const Value& v : {Value{0.5, at_twice}, Value{1.0, at_own}, Value{2.0, at_half}}) {
    if (!std::isfinite(v.value)) continue;
    sizes.push_back(v.size);
    values.push_back(v.value);
  }
  if (values.size() < 2 || !std::isfinite(at_own)) return error;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double spread = *most - *least;
  error.extrapolated = values.front();
  if (spread <= kSettled * std::abs(at_own)) {
    error.trend = SegmentsTrend::Settled;
    set_by_spread(spread, error);
    error.error = std::max(error.error, kSettled * std::abs(at_own));
    error.extrapolated_error = error.error;
    return error;
  }
  error.trend = SegmentsTrend::Assumed;
  error.order = joints_order;
  error.safety_factor = kUnsafe;
  if (values.size() == 3) {
    const theory::GridConvergence observed = theory::grid_convergence(sizes, values);
    error.observed_order = observed.observed_order.value_or(SegmentsError::kNone);
    const bool falls = observed.observed_order && *observed.observed_order >= kMinOrder;
    if (!falls || observed.kind == theory::ConvergenceKind::Oscillatory) {
      error.trend = falls ? SegmentsTrend::Oscillates : SegmentsTrend::Diverges;
      error.order = SegmentsError::kNone;
      set_by_spread(spread, error);
      return error;
    }
    error.trend = SegmentsTrend::Monotone;
    error.order = std::min(*observed.observed_order, joints_order);
    if (*observed.observed_order <= joints_order + kBeyond) error.safety_factor = kSafe;
  }
  const double ratio = sizes[1] / sizes[0];
  error.extrapolated = theory::richardson(values[0], values[1], ratio, error.order);
  error.extrapolated_error = error.safety_factor * std::abs(error.extrapolated - values[0]);
  error.error = error.safety_factor * std::abs(error.extrapolated - at_own);
  if (values.size() == 3) {
    const double other = theory::limit_of_two_orders(sizes, values);
    error.extrapolated_error =
        std::max(error.extrapolated_error, kSafe * std::abs(other - values[0]));
    error.error = std::max(error.error, kSafe * std::abs(other - at_own));
  }
  return error;
}

}  // namespace plastica::calibrate
