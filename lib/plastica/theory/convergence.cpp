#include "plastica/theory/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

/// So much of the values' size is taken for rounding.
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Sizes that differ by less are one size, computed twice.
constexpr double kSameSize = 1e-12;

/// Checks a series; the indices of its points from the finest to the coarsest.
std::vector<std::size_t> finest_first(std::span<const double> sizes, std::span<const double> values,
                                      std::string_view name) {
  if (values.size() != sizes.size()) {
    throw InputError({}, name, fmt::format("{} numbers", values.size()),
                     fmt::format("must be as many as sizes, {}", sizes.size()));
  }
  for (const double value : values) {
    if (!std::isfinite(value)) throw InputError({}, name, fmt::to_string(value), "must be finite");
  }
  for (const double size : sizes) {
    if (!(size > 0.0) || !std::isfinite(size)) {
      throw InputError({}, "sizes", fmt::to_string(size), "must be positive and finite");
    }
  }
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (sizes[order[i]] <= sizes[order[i - 1]] * (1.0 + kSameSize)) {
      throw InputError({}, "sizes", fmt::to_string(sizes[order[i]]), "must not appear twice");
    }
  }
  return order;
}

/// A point of a series in logarithms: x = log h, y = log|error|.
struct LogPoint {
  std::size_t index;  // in the input
  double x;
  double y;
};

struct LogLine {
  double order;
  double intercept;
  double correlation;
  double scatter;  // rms distance of the points in y

  double at(double x) const { return intercept + order * x; }
};

/// Least squares; needs two points.
LogLine line_through(std::span<const LogPoint> points) {
  const auto n = static_cast<double>(points.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const LogPoint& point : points) {
    mean_x += point.x / n;
    mean_y += point.y / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const LogPoint& point : points) {
    xx += (point.x - mean_x) * (point.x - mean_x);
    xy += (point.x - mean_x) * (point.y - mean_y);
    yy += (point.y - mean_y) * (point.y - mean_y);
  }
  LogLine line{};
  line.order = xy / xx;
  line.intercept = mean_y - line.order * mean_x;
  line.correlation = yy > 0.0 ? xy / std::sqrt(xx * yy) : 0.0;
  double squares = 0.0;
  for (const LogPoint& point : points) {
    squares += (point.y - line.at(point.x)) * (point.y - line.at(point.x));
  }
  line.scatter = std::sqrt(squares / n);
  return line;
}

bool falls_clearly(std::span<const LogPoint> points, const LogLine& line) {
  constexpr double kMinOrder = 0.5;
  constexpr double kMinCorrelation = 0.9;
  constexpr double kClearFall = 10.0;
  if (points.size() == 2) return points[0].y - points[1].y >= std::log(kClearFall);
  return line.order >= kMinOrder && line.correlation >= kMinCorrelation;
}

/// How many points remain, the coarsest first, when those next to a floor go that are off the line
/// of the coarser ones: the floor's fraction of their error is no longer small.
std::size_t trim_edge(std::span<const LogPoint> points) {
  constexpr double kMinDistance = 1.25;  // from the line, as a factor
  for (; points.size() > 2; points = points.first(points.size() - 1)) {
    const auto coarser = points.first(points.size() - 1);
    const LogLine line = line_through(coarser);
    const double distance = std::abs(points.back().y - line.at(points.back().x));
    if (!falls_clearly(coarser, line) ||
        distance <= std::max(std::log(kMinDistance), 3.0 * line.scatter)) {
      break;
    }
  }
  return points.size();
}

/// How many of the points, the coarsest first, are above the floor.
std::size_t count_above_floor(std::span<const LogPoint> points, double log_limit) {
  constexpr double kMinRise = 2.0;  // above the line, as a factor
  for (std::size_t count = 2; count < points.size(); ++count) {
    const auto coarser = points.first(count);
    const LogLine line = line_through(coarser);
    if (!falls_clearly(coarser, line)) continue;
    const double last = coarser.back().x;
    const double rise = std::max(std::log(kMinRise), 3.0 * line.scatter);
    const auto finer = points.subspan(count);
    if (std::all_of(finer.begin(), finer.end(), [&](const LogPoint& point) {
          return point.y <= log_limit && point.y >= line.at(point.x) + rise &&
                 point.y >= line.at(last) - 0.5 * line.order * (last - point.x);
        })) {
      return trim_edge(coarser);
    }
  }
  return points.size();
}

/// The order p > 0 for which the left side of the header's equation has a value; empty if none.
/// @param a, b   ln r21, ln r32
/// @param sign   s
/// @param wanted ln|e_32/e_21|
std::optional<double> solve_order(double a, double b, double sign, double wanted) {
  // 1 - exp(-x) without cancellation, 1 + exp(-x).
  const auto log_term = [sign](double x) {
    return sign > 0.0 ? std::log(-std::expm1(-x)) : std::log1p(std::exp(-x));
  };
  const auto left = [&](double p) { return b * p + log_term(b * p) - log_term(a * p); };
  const double at_zero = sign > 0.0 ? std::log(b / a) : 0.0;
  if (!(wanted > at_zero)) return std::nullopt;
  double high = 1.0;
  while (left(high) < wanted) high *= 2.0;
  double low = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (left(middle) < wanted ? low : high) = middle;
  }
  return high;
}

std::optional<double> ratio_of(double part, double whole) {
  if (whole == 0.0) return std::nullopt;
  return std::abs(part / whole);
}

/// Kind and observed order of three values, the finest first.
void classify(const std::array<double, 3>& f, GridConvergence& result) {
  const double e21 = f[1] - f[0];
  const double e32 = f[2] - f[1];
  if (std::abs(e21) <= kRounding * std::max(std::abs(f[0]), std::abs(f[1]))) {
    result.kind = ConvergenceKind::Unchanged;
    return;
  }
  result.kind = ConvergenceKind::Divergent;
  if (std::abs(e32) <= kRounding * std::max(std::abs(f[1]), std::abs(f[2]))) return;
  const double sign = (e32 > 0.0) == (e21 > 0.0) ? 1.0 : -1.0;
  result.observed_order = solve_order(std::log(result.r21), std::log(*result.r32), sign,
                                      std::log(std::abs(e32)) - std::log(std::abs(e21)));
  if (!result.observed_order) return;
  result.kind = sign > 0.0 ? ConvergenceKind::Monotone : ConvergenceKind::Oscillatory;
}

/// Takes no more from the observed order of three values than a method of the highest order allows.
void mistrust_order(std::span<const double> h, std::span<const double> f, double highest,
                    GridConvergence& result) {
  constexpr double kSafetyOfAssumed = 3.0;
  const bool differs = std::abs(f[2] - f[1]) > kRounding * std::max(std::abs(f[1]), std::abs(f[2]));
  if ((result.kind == ConvergenceKind::Monotone &&
       *result.observed_order > highest + kBeyondHighestOrder) ||
      (result.kind == ConvergenceKind::Unchanged && differs)) {
    result.kind = ConvergenceKind::TooFast;
  }
  if (result.kind == ConvergenceKind::Monotone) {
    result.order = std::min(*result.observed_order, highest);
    const double reduction = std::expm1(*result.order * std::log(result.r21));
    result.extrapolated = f[0] + (f[0] - f[1]) / reduction;
    result.uncertainty =
        result.safety_factor *
        std::max(std::abs(*result.extrapolated - f[0]), std::abs(limit_of_two_orders(h, f) - f[0]));
  } else if (result.kind == ConvergenceKind::TooFast ||
             result.kind == ConvergenceKind::Oscillatory) {
    result.order.reset();
    result.extrapolated.reset();
    result.safety_factor = kSafetyOfAssumed;
    const double off = std::max(std::abs(f[1] - f[0]) / (h[1] / h[0] - 1.0),
                                std::abs(f[2] - f[0]) / (h[2] / h[0] - 1.0));
    result.uncertainty = result.safety_factor * off;
  }
}

}  // namespace

OrderFit observed_order(std::span<const double> sizes, std::span<const double> errors,
                        const OrderOptions& options) {
  require_domain(options.scale > 0.0, "options.scale > 0.0");
  const std::vector<std::size_t> order = finest_first(sizes, errors, "errors");
  std::vector<LogPoint> points;
  points.reserve(order.size());
  for (auto at = order.rbegin(); at != order.rend(); ++at) {
    const double error = std::abs(errors[*at]);
    if (error <= kRounding * options.scale) continue;
    points.push_back({*at, std::log(sizes[*at]), std::log(error)});
  }
  points.resize(count_above_floor(points, std::log(options.floor_limit * options.scale)));

  OrderFit fit;
  fit.points = points.size();
  fit.used.resize(sizes.size());
  for (const LogPoint& point : points) fit.used[point.index] = true;
  if (points.size() < 2) return fit;
  const LogLine line = line_through(points);
  fit.order = line.order;
  fit.constant = std::exp(line.intercept);
  fit.correlation = line.correlation;
  return fit;
}

std::vector<std::optional<double>> pairwise_orders(std::span<const double> sizes,
                                                   std::span<const double> errors) {
  const std::vector<std::size_t> order = finest_first(sizes, errors, "errors");
  std::vector<std::optional<double>> orders;
  for (std::size_t i = order.size(); i-- > 1;) {
    const std::size_t coarse = order[i];
    const std::size_t fine = order[i - 1];
    if (errors[coarse] == 0.0 || errors[fine] == 0.0) {
      orders.emplace_back();
      continue;
    }
    orders.emplace_back((std::log(std::abs(errors[coarse])) - std::log(std::abs(errors[fine]))) /
                        std::log(sizes[coarse] / sizes[fine]));
  }
  return orders;
}

double richardson(double fine, double coarse, double ratio, double order) {
  require_domain(ratio > 1.0 && order > 0.0, "ratio > 1.0 && order > 0.0");
  return fine + (fine - coarse) / std::expm1(order * std::log(ratio));
}

double limit_of_two_orders(std::span<const double> sizes, std::span<const double> values) {
  require_domain(sizes.size() == 3 && values.size() == 3,
                 "sizes.size() == 3 && values.size() == 3");
  double limit = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = sizes[(i + 1) % 3];
    const double b = sizes[(i + 2) % 3];
    limit += values[i] * a / (a - sizes[i]) * b / (b - sizes[i]);
  }
  return limit;
}

GridConvergence grid_convergence(std::span<const double> sizes, std::span<const double> values,
                                 const GridOptions& options) {
  const std::vector<std::size_t> at = finest_first(sizes, values, "values");
  if (at.size() < 2 || (at.size() == 2 && !options.order)) {
    throw InputError({}, "values", fmt::format("{} numbers", at.size()),
                     "must be three or more, or two with a given order");
  }
  if (options.order && !(*options.order > 0.0)) {
    throw InputError({}, "order", fmt::to_string(*options.order), "must be positive");
  }
  if (options.order && options.highest_order) {
    throw InputError({}, "order", fmt::to_string(*options.order),
                     "must not be given together with the highest one");
  }
  if (options.safety_factor && !(*options.safety_factor > 0.0)) {
    throw InputError({}, "safety_factor", fmt::to_string(*options.safety_factor),
                     "must be positive");
  }
  const bool three = at.size() > 2;
  const std::array<double, 3> f{values[at[0]], values[at[1]], three ? values[at[2]] : 0.0};
  GridConvergence result;
  result.safety_factor = options.safety_factor.value_or(three ? 1.25 : 3.0);
  result.r21 = sizes[at[1]] / sizes[at[0]];
  if (three) {
    result.r32 = sizes[at[2]] / sizes[at[1]];
    classify(f, result);
  }
  const double step = f[0] - f[1];
  result.approximate_error = ratio_of(step, f[0]);
  result.order = options.order ? options.order : result.observed_order;
  if (result.kind == ConvergenceKind::Divergent) {
    result.order.reset();
    return result;
  }
  // Where the two agree to rounding, no order is needed to see that nothing is left.
  const double reduction = result.order ? std::expm1(*result.order * std::log(result.r21))
                                        : std::numeric_limits<double>::infinity();
  result.extrapolated = f[0] + step / reduction;
  result.uncertainty = result.safety_factor * std::abs(step) / reduction;
  if (three && options.highest_order) {
    const std::array<double, 3> h{sizes[at[0]], sizes[at[1]], sizes[at[2]]};
    mistrust_order(h, f, *options.highest_order, result);
  }
  if (result.extrapolated) {
    result.extrapolated_error = ratio_of(*result.extrapolated - f[0], *result.extrapolated);
  }
  result.fine_index = ratio_of(*result.uncertainty, f[0]);
  if (!three || !result.order || options.highest_order) return result;
  const double coarse_reduction = std::expm1(*result.order * std::log(*result.r32));
  result.coarse_index = ratio_of(result.safety_factor * (f[1] - f[2]) / coarse_reduction, f[1]);
  if (result.coarse_index && result.fine_index && *result.fine_index > 0.0) {
    result.asymptotic_ratio = *result.coarse_index / ((reduction + 1.0) * *result.fine_index);
  }
  return result;
}

}  // namespace plastica::theory
