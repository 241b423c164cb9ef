#include "plastica/report/strain_color.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace plastica::report {
namespace {

using Color = std::array<double, 3>;
constexpr std::array<std::pair<double, Color>, 4> kStops{{{0.0, {0xB4, 0xC8, 0xDA}},
                                                          {0.3, {0xF2, 0xD1, 0x6B}},
                                                          {0.65, {0xE8, 0x80, 0x3A}},
                                                          {1.0, {0xA6, 0x1C, 0x1C}}}};

}  // namespace

double color_at(double fraction, double light) {
  std::size_t k = 1;
  while (k + 1 < kStops.size() && fraction > kStops[k].first) ++k;
  const auto& [low, from] = kStops[k - 1];
  const auto& [high, to] = kStops[k];
  const double t = std::clamp((fraction - low) / (high - low), 0.0, 1.0);
  double number = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    number = 256.0 * number + std::floor(light * (from[c] + t * (to[c] - from[c])));
  }
  return number;
}

std::string strain_palette() {
  std::string text;
  for (const auto& [fraction, color] : kStops) {
    text += fmt::format("{}{} '#{:02X}{:02X}{:02X}'", text.empty() ? "" : ", ", fraction,
                        static_cast<int>(color[0]), static_cast<int>(color[1]),
                        static_cast<int>(color[2]));
  }
  return "set palette defined (" + text + ")";
}

}  // namespace plastica::report
