#include "plastica/report/axis_ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "plastica/report/format.hpp"
#include "plastica/report/plot_script.hpp"

namespace plastica::report {
namespace {

/// Digits that tell numbers apart which differ by a step.
int digits_for(const std::array<double, 2>& range, double step) {
  constexpr int kUsual = 6;
  constexpr int kMost = 15;
  const double largest = std::max(std::fabs(range[0]), std::fabs(range[1]));
  return std::clamp(static_cast<int>(std::ceil(std::log10(largest / step))) + 1, kUsual, kMost);
}

std::vector<AxisTick> multiples_of(double step, const std::array<double, 2>& range) {
  constexpr double kSame = 1e-9;  // of a step
  const int digits = digits_for(range, step);
  const double first = std::ceil(range[0] / step - kSame);
  const double last = std::floor(range[1] / step + kSame);
  std::vector<AxisTick> ticks;
  for (double k = first; k <= last; ++k) {
    const double at = k == 0.0 ? 0.0 : k * step;
    ticks.push_back({at, fmt::format("{:.{}g}", at, digits)});
  }
  return ticks;
}

/// Of two neighbours, from the middle of one to that of the other.
double room_for(const std::vector<AxisTick>& ticks) {
  constexpr double kLetter = 10.0;
  std::size_t letters = 0;
  for (const AxisTick& tick : ticks) letters = std::max(letters, tick.text.size());
  return kLetter * static_cast<double>(letters + 1);
}

}  // namespace

std::vector<AxisTick> ticks_with_room(const std::array<double, 2>& range, double panel) {
  const double wide = range[1] - range[0];
  std::vector<AxisTick> ticks;
  for (int most = 6; most >= 2; --most) {
    const double step = round_step(wide, most);
    std::vector<AxisTick> some = multiples_of(step, range);
    if (some.size() < 2) break;  // fewer are further apart
    ticks = std::move(some);
    if (room_for(ticks) * wide / step <= panel) break;
  }
  // Two that have no room side by side are those that stand furthest apart.
  const bool crowded =
      ticks.size() > 2 && room_for(ticks) > (ticks[1].at - ticks[0].at) / wide * panel;
  if (crowded) ticks = {ticks.front(), ticks.back()};
  if (ticks.size() > 2) {
    const AxisTick& last = ticks.back();
    const double half = 0.5 * kLetterWidth * static_cast<double>(last.text.size());
    if ((last.at - range[1]) / wide * panel + half > kRightRoom) ticks.pop_back();
  }
  return ticks;
}

}  // namespace plastica::report
