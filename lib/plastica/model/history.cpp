#include "plastica/model/history.hpp"

#include <algorithm>
#include <cstddef>

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

}  // namespace

History History::turning_points(const std::vector<double>& factors) {
  History history{{0.0}, {0.0}};
  for (const double factor : factors) {
    history.time.push_back(history.time.back() + 1.0);
    history.factor.push_back(factor);
  }
  return history;
}

double History::at(double when) const {
  if (when <= time.front() && !continues) return factor.front();
  if (when >= time.back() && !continues) return factor.back();
  const std::size_t piece = piece_of(*this, when);
  return factor[piece] + slope_of(*this, piece) * (when - time[piece]);
}

double History::slope_at(double when) const {
  if ((when < time.front() || when >= time.back()) && !continues) return 0.0;
  return slope_of(*this, piece_of(*this, when));
}

}  // namespace plastica
