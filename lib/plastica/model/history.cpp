#include "plastica/model/history.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace plastica {
namespace {

/// The piece that `time` lies in, by its first point: the last piece that begins at or before it.
std::size_t piece_of(const History& history, double time) {
  const auto after = std::upper_bound(history.time.begin(), history.time.end() - 1, time);
  return after == history.time.begin() ? 0
                                       : static_cast<std::size_t>(after - history.time.begin()) - 1;
}

double slope_of(const History& history, std::size_t piece) {
  return (history.factor[piece + 1] - history.factor[piece]) /
         (history.time[piece + 1] - history.time[piece]);
}

/// A piece as a cubic of s = 0 … 1: f0 + s (d + (1 - s) (a (1 - s) - b s)), with the rise d and
/// what the slopes at both ends are above the chord's, a and b, times the length.
struct Cubic {
  double length, s, from, rise, a, b;

  Cubic(const History& history, std::size_t piece, double when)
      : length(history.time[piece + 1] - history.time[piece]),
        s((when - history.time[piece]) / length),
        from(history.factor[piece]),
        rise(history.factor[piece + 1] - from),
        a(length * history.slope[piece] - rise),
        b(length * history.slope[piece + 1] - rise) {}

  double value() const { return from + s * (rise + (1.0 - s) * (a * (1.0 - s) - b * s)); }
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
  constexpr double kPieces = 128.0;
  const double rate = 2.0 * std::numbers::pi / period;
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(kPieces * cycles - 1e-9)));
  History history{{}, {}};
  for (std::size_t i = 0; i <= pieces; ++i) {
    const double periods = std::min(static_cast<double>(i) / kPieces, cycles);
    const double angle = 2.0 * std::numbers::pi * periods + phase;
    history.time.push_back(periods * period);
    history.factor.push_back(offset + std::sin(angle));
    history.slope.push_back(rate * std::cos(angle));
  }
  return history;
}

std::vector<double> History::corners() const {
  if (slope.empty()) return time;
  return {time.front(), time.back()};
}

std::vector<double> History::turns() const {
  std::vector<double> times;
  for (std::size_t piece = 0; piece + 1 < slope.size(); ++piece) {
    const double begin = time[piece];
    const double end = time[piece + 1];
    if (piece > 0 && slope[piece] == 0.0 && slope[piece - 1] * slope[piece + 1] < 0.0) {
      times.push_back(begin);
    }
    if (!(slope[piece] * slope[piece + 1] < 0.0)) continue;
    double low = begin;
    double high = end;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const bool before = Cubic(*this, piece, middle).slope() * slope[piece] > 0.0;
      (before ? low : high) = middle;
    }
    times.push_back(high);
  }
  return times;
}

double History::at(double when) const {
  if (when <= time.front() && !continues) return factor.front();
  if (when >= time.back() && !continues) return factor.back();
  const std::size_t piece = piece_of(*this, when);
  if (!slope.empty()) return Cubic(*this, piece, when).value();
  return factor[piece] + slope_of(*this, piece) * (when - time[piece]);
}

double History::slope_at(double when) const {
  if ((when < time.front() || when >= time.back()) && !continues) return 0.0;
  const std::size_t piece = piece_of(*this, when);
  if (!slope.empty()) return Cubic(*this, piece, when).slope();
  return slope_of(*this, piece);
}

}  // namespace plastica
