#include "calibrate/target/characteristics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plastica/base/median.hpp"

namespace plastica::calibrate {

bool sees_offset(double modulus, double offset, double noise) {
  return 6.0 * noise < modulus * offset;
}

namespace {

/// See `noise_of`.
/// @param fraction  of the way from the sample before to the one behind that a sample has gone, of
///                  its index
template <typename Fraction>
double noise_between(std::span<const double> values, const Fraction& fraction) {
  if (values.size() < 5) return 0.0;
  // Enough for a median, and a curve of many thousand samples costs no more than a short one.
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 2000);
  std::vector<double> bends;
  bends.reserve(values.size() / stride + 1);
  // A load cell at its limit has no noise there, and a coarse one repeats itself.
  const double nothing = 1e-12 * largest_magnitude(values);  // but for rounding
  std::size_t left = 0;
  for (std::size_t i = 1; i + 1 < values.size(); i += stride) {
    const double a = fraction(i);
    const double off = values[i] - (1.0 - a) * values[i - 1] - a * values[i + 1];
    const double bend = std::abs(off) / std::sqrt(1.0 + a * a + (1.0 - a) * (1.0 - a));
    bends.push_back(bend);
    left += bend <= nothing ? 0 : 1;
  }
  // Noise is nowhere still by chance. Fewer that move are corners of a curve without any noise, and
  // of a short one what moves may be its bends.
  const std::size_t all = bends.size();
  const std::size_t few = 2 * left <= all ? 20 : 100;
  const bool is_still = 20 * (all - left) >= all && 10 * left >= all && left >= few;
  // What is still stands before all that moves.
  return value_of_rank(bends, is_still ? all - left + left / 2 : all / 2) / 0.6745;
}

}  // namespace

double noise_of(std::span<const double> strain, std::span<const double> stress) {
  return noise_between(stress, [&](std::size_t i) {
    const double gap = strain[i + 1] - strain[i - 1];
    return gap != 0.0 ? std::clamp((strain[i] - strain[i - 1]) / gap, 0.0, 1.0) : 0.5;
  });
}

double noise_over_rows(std::span<const double> values) {
  return noise_between(values, [](std::size_t) { return 0.5; });
}

std::optional<double> Characteristics::sound_modulus() const {
  constexpr double kLargestError = 0.05;
  const bool vague = youngs_modulus && youngs_modulus_stderr &&
                     !(*youngs_modulus_stderr <= kLargestError * std::abs(*youngs_modulus));
  return vague ? std::nullopt : youngs_modulus;
}

double Characteristics::permanent_strain_error() const {
  if (!observed_break) return 0.0;
  const double half = observed_break->half_interval();
  if (!youngs_modulus || !youngs_modulus_stderr) return half;
  const double elastic = observed_break->last_intact_stress / *youngs_modulus;
  return std::hypot(half, elastic * *youngs_modulus_stderr / *youngs_modulus);
}

std::optional<double> proof_stress(std::span<const double> strain, std::span<const double> stress,
                                   double modulus, double zero_strain, double offset) {
  const auto above = [&](std::size_t i) {
    return stress[i] - modulus * (strain[i] - zero_strain - offset);
  };
  if (stress.empty() || above(stress.size() - 1) > 0.0) return std::nullopt;
  for (std::size_t i = stress.size() - 1; i > 0; --i) {
    const double before = above(i - 1);
    if (before <= 0.0) continue;
    const double fraction = before / (before - above(i));
    return stress[i - 1] + fraction * (stress[i] - stress[i - 1]);
  }
  return std::nullopt;
}

std::optional<YieldPoint> find_yield_point(std::span<const double> stress, double noise,
                                           double yield_drop) {
  if (stress.empty()) return std::nullopt;
  const double largest = *std::max_element(stress.begin(), stress.end());
  YieldPoint point{stress[0], stress[0]};
  bool dropped = false;
  const auto least_drop = [&] { return std::max(yield_drop * point.upper, 8.0 * noise); };
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double value = stress[i];
    if (value > point.upper) {
      if (dropped) {
        point.until = i;
        return point;
      }
      point = {value, value, i, i};
    }
    if (value < point.lower) {
      point.lower = value;
      point.lower_at = i;
    }
    // A stumble at the foot is no yield point.
    dropped = dropped || (point.upper > 0.3 * largest && point.upper - point.lower > least_drop());
  }
  // To the largest climb after it, where the end falls below all.
  double lower = point.upper;
  std::size_t lower_at = point.at;
  double climb = 0.0;
  for (std::size_t i = point.at; i < stress.size(); ++i) {
    if (stress[i] < lower) {
      lower = stress[i];
      lower_at = i;
    }
    if (stress[i] - lower <= climb) continue;
    climb = stress[i] - lower;
    point.lower = lower;
    point.lower_at = lower_at;
    point.later_peak = point.until = i;
  }
  if (!dropped || climb <= least_drop() || point.upper - point.lower <= least_drop()) {
    return std::nullopt;
  }
  return point;
}

void leave_out_transient(std::span<const double> strain, std::span<const double> stress,
                         double noise, double yield_drop, YieldPoint& point) {
  constexpr double kLongest = 0.0025, kStays = 3.0, kHigher = 0.05, kTimes = 3.0;
  const double least = std::max(yield_drop * point.upper, 8.0 * noise);
  const auto lowest_from = [&](std::size_t i) {
    const auto begin = stress.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = stress.begin() + static_cast<std::ptrdiff_t>(point.until);
    return static_cast<std::size_t>(std::min_element(begin, end) - stress.begin());
  };
  const double from = strain[point.at];
  for (std::size_t i = point.lower_at + 1; i < point.until; ++i) {
    const double length = strain[i] - from;
    if (length > kLongest) return;
    const std::size_t lowest = lowest_from(i);
    const double depth = stress[lowest] - point.lower;
    if (!(length > 0.0 && depth > least)) continue;
    std::size_t stays = i;
    while (stays < point.until && strain[stays] < from + kStays * length) ++stays;
    if (stays == point.until) return;
    const double higher = stress[lowest_from(stays)] - stress[lowest];
    if (higher > std::max(kHigher * depth, kTimes * noise)) continue;
    if (point.upper - stress[lowest] <= least) return;  // a pause on a plateau
    point.lower = stress[lowest];
    point.lower_at = lowest;
    return;
  }
}

}  // namespace plastica::calibrate
