#include "plastica/report/web/packed_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace plastica::report {
namespace {

constexpr double kSteps = 65534.0;
constexpr std::uint16_t kGap = 65535;

std::string base64(const std::vector<std::uint16_t>& numbers) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((2 * numbers.size() + 2) / 3 * 4);
  std::uint32_t bits = 0;
  int count = 0;
  const auto put = [&](std::uint32_t byte) {
    bits = (bits << 8U) | byte;
    count += 8;
    while (count >= 6) {
      count -= 6;
      text += kDigits[(bits >> static_cast<unsigned>(count)) & 63U];
    }
  };
  for (const std::uint16_t number : numbers) {
    put(number & 255U);
    put(static_cast<std::uint32_t>(number) >> 8U);
  }
  if (count > 0) text += kDigits[(bits << static_cast<unsigned>(6 - count)) & 63U];
  while (text.size() % 4 != 0) text += '=';
  return text;
}

/// What of a column is shown.
struct Column {
  bool logarithmic = false;
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  double shown(double value) const {
    if (!logarithmic) return value;
    return value > 0.0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
  }
  void enclose(double value) {
    const double number = shown(value);
    if (!std::isfinite(number)) return;
    low = std::min(low, number);
    high = std::max(high, number);
  }
  /// From 0 to 1; NaN of a gap.
  double fraction(double value) const {
    const double number = shown(value);
    if (!std::isfinite(number)) return std::numeric_limits<double>::quiet_NaN();
    // Halves: the size of all that a double holds is none.
    const double size = 0.5 * high - 0.5 * low;
    return size > 0.0 ? std::clamp((0.5 * number - 0.5 * low) / size, 0.0, 1.0) : 0.0;
  }
};

bool is_gap(const std::vector<double>& fractions) {
  return std::ranges::any_of(fractions, [](double f) { return !std::isfinite(f); });
}

/// Whether a point falls on the spot of the one before it.
bool same_spot(const std::vector<double>& a, const std::vector<double>& b, double spots) {
  if (a.empty() || is_gap(a) || is_gap(b)) return !a.empty() && is_gap(a) && is_gap(b);
  return std::ranges::equal(a, b, [spots](double x, double y) {
    return std::floor(spots * x) == std::floor(spots * y);
  });
}

}  // namespace

Json packed_points(const std::vector<std::vector<double>>& points, std::array<bool, 2> logarithmic,
                   int spots) {
  const std::size_t width = points.empty() ? 0 : points.front().size();
  std::vector<Column> columns(width);
  for (std::size_t c = 0; c < width; ++c) {
    columns[c].logarithmic = logarithmic[c == 0 ? 0 : 1];
    for (const auto& point : points) columns[c].enclose(point[c]);
  }
  std::vector<std::vector<std::uint16_t>> kept(width);
  std::vector<double> last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<double> now(width);
    for (std::size_t c = 0; c < width; ++c) now[c] = columns[c].fraction(points[i][c]);
    if (spots > 0 && same_spot(last, now, spots) && i + 1 < points.size()) continue;
    for (std::size_t c = 0; c < width; ++c) {
      kept[c].push_back(is_gap(now) ? kGap
                                    : static_cast<std::uint16_t>(std::lround(kSteps * now[c])));
    }
    last = std::move(now);
  }
  Json low = Json::array();
  Json high = Json::array();
  Json texts = Json::array();
  for (std::size_t c = 0; c < width; ++c) {
    low.push_back(number(columns[c].low));
    high.push_back(number(columns[c].high));
    texts.push_back(base64(kept[c]));
  }
  return {{"n", width == 0 ? 0 : kept[0].size()},
          {"low", std::move(low)},
          {"high", std::move(high)},
          {"logarithmic", {logarithmic[0], logarithmic[1]}},
          {"columns", std::move(texts)}};
}

}  // namespace plastica::report
