#include "plastica/model/history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace plastica {
namespace {

/// The segment that `time` lies in, by its first point: the last segment that begins at or before
/// it.
std::size_t segment_of(const History& history, double time) {
  const auto after = std::upper_bound(history.time.begin(), history.time.end() - 1, time);
  return after == history.time.begin() ? 0
                                       : static_cast<std::size_t>(after - history.time.begin()) - 1;
}

double slope_of(const History& history, std::size_t segment) {
  return (history.factor[segment + 1] - history.factor[segment]) /
         (history.time[segment + 1] - history.time[segment]);
}

/// A segment as a cubic of s = 0 … 1: f0 + s (d + (1 - s) (a (1 - s) - b s)), with the rise d and
/// what the slopes at both ends are above the chord's, a and b, times the length.
struct Cubic {
  double length, s, from, rise, a, b;

  Cubic(const History& history, std::size_t segment, double when)
      : length(history.time[segment + 1] - history.time[segment]),
        s((when - history.time[segment]) / length),
        from(history.factor[segment]),
        rise(history.factor[segment + 1] - from),
        a(length * history.slope[segment] - rise),
        b(length * history.slope[segment + 1] - rise) {}

  double value() const { return from + s * (rise + (1.0 - s) * (a * (1.0 - s) - b * s)); }
  double curvature() const {
    return (a * (6.0 * s - 4.0) + b * (6.0 * s - 2.0)) / (length * length);
  }
  double slope() const {
    return (rise + a * (1.0 - s) * (1.0 - 3.0 * s) + b * s * (3.0 * s - 2.0)) / length;
  }
};

}  // namespace

History History::turning_points(const std::vector<double>& factors) {
  History history{{0.0}, {0.0}};
  for (const double factor : factors) {
    history.time.push_back(history.time.back() + 1.0);
    history.factor.push_back(factor);
  }
  return history;
}

History History::smooth_step(double from, double to) {
  return {{from, to}, {0.0, 1.0}, false, {0.0, 0.0}};
}

History History::sine(double period, double cycles, double phase, double offset) {
  constexpr double kSegments = 128.0;
  const double rate = 2.0 * std::numbers::pi / period;
  const auto segments =
      static_cast<std::size_t>(std::max(1.0, std::ceil(kSegments * cycles - 1e-9)));
  History history{{}, {}};
  for (std::size_t i = 0; i <= segments; ++i) {
    const double periods = std::min(static_cast<double>(i) / kSegments, cycles);
    const double angle = 2.0 * std::numbers::pi * periods + phase;
    history.time.push_back(periods * period);
    history.factor.push_back(offset + std::sin(angle));
    history.slope.push_back(rate * std::cos(angle));
  }
  return history;
}

History History::spline(std::vector<double> time, std::vector<double> factor) {
  const std::size_t n = time.size();
  std::vector<double> length(n - 1), chord(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    length[i] = time[i + 1] - time[i];
    chord[i] = (factor[i + 1] - factor[i]) / length[i];
  }
  std::vector<double> slope(n, chord[0]);
  if (n == 3) {
    const double bend = (chord[1] - chord[0]) / (length[0] + length[1]);
    slope = {chord[0] - bend * length[0], chord[0] + bend * length[0], chord[1] + bend * length[1]};
  } else if (n > 3) {
    // below_i slope_(i-1) + middle_i slope_i + above_i slope_(i+1) = slope's right side: the
    // curvatures of two segments agree at the point between them. Of an end, the third derivatives
    // at its neighbour, with the one beyond that eliminated.
    std::vector<double> below(n), middle(n), above(n);
    const auto end_row = [](double own, double next, double own_chord, double next_chord) {
      const double both = own + next;
      return ((own + 2.0 * both) * next * own_chord + own * own * next_chord) / both;
    };
    middle[0] = length[1];
    above[0] = length[0] + length[1];
    slope[0] = end_row(length[0], length[1], chord[0], chord[1]);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      below[i] = length[i];
      middle[i] = 2.0 * (length[i - 1] + length[i]);
      above[i] = length[i - 1];
      slope[i] = 3.0 * (length[i] * chord[i - 1] + length[i - 1] * chord[i]);
    }
    below[n - 1] = length[n - 2] + length[n - 3];
    middle[n - 1] = length[n - 3];
    slope[n - 1] = end_row(length[n - 2], length[n - 3], chord[n - 2], chord[n - 3]);
    for (std::size_t i = 1; i < n; ++i) {
      const double factor_of_row = below[i] / middle[i - 1];
      middle[i] -= factor_of_row * above[i - 1];
      slope[i] -= factor_of_row * slope[i - 1];
    }
    slope[n - 1] /= middle[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) {
      slope[i] = (slope[i] - above[i] * slope[i + 1]) / middle[i];
    }
  }
  return {std::move(time), std::move(factor), false, std::move(slope)};
}

std::vector<double> History::corners() const {
  if (slope.empty()) return time;
  return {time.front(), time.back()};
}

std::vector<double> History::reversals() const {
  std::vector<double> times;
  for (std::size_t segment = 0; segment + 1 < slope.size(); ++segment) {
    const double begin = time[segment];
    const double end = time[segment + 1];
    if (segment > 0 && slope[segment] == 0.0 && slope[segment - 1] * slope[segment + 1] < 0.0) {
      times.push_back(begin);
    }
    if (!(slope[segment] * slope[segment + 1] < 0.0)) continue;
    double low = begin;
    double high = end;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const bool before = Cubic(*this, segment, middle).slope() * slope[segment] > 0.0;
      (before ? low : high) = middle;
    }
    times.push_back(high);
  }
  return times;
}

double History::at(double when) const {
  if (when <= time.front() && !continues) return factor.front();
  if (when >= time.back() && !continues) return factor.back();
  const std::size_t segment = segment_of(*this, when);
  if (!slope.empty()) return Cubic(*this, segment, when).value();
  return factor[segment] + slope_of(*this, segment) * (when - time[segment]);
}

double History::slope_at(double when) const {
  if ((when < time.front() || when >= time.back()) && !continues) return 0.0;
  const std::size_t segment = segment_of(*this, when);
  if (!slope.empty()) return Cubic(*this, segment, when).slope();
  return slope_of(*this, segment);
}

History::SlopeChange History::slopes_about(double when, double tolerance) const {
  const auto after = std::lower_bound(time.begin(), time.end(), when - tolerance);
  if (after == time.end() || *after >= when + tolerance) {
    const double own = slope_at(when);
    return {own, own};
  }
  const auto point = static_cast<std::size_t>(after - time.begin());
  const bool first = point == 0;
  const bool last = point + 1 == time.size();
  if (!slope.empty()) {
    return {first ? 0.0 : slope[point], last ? 0.0 : slope[point], first || last};
  }
  const bool goes_on = continues && !(first && last);
  const auto beyond = [&](std::size_t segment) { return goes_on ? slope_of(*this, segment) : 0.0; };
  return {first ? beyond(0) : slope_of(*this, point - 1),
          last ? beyond(point - 1) : slope_of(*this, point)};
}

double History::curvature_at(double when) const {
  if (slope.empty() || when < time.front() || when >= time.back()) return 0.0;
  return Cubic(*this, segment_of(*this, when), when).curvature();
}

}  // namespace plastica
