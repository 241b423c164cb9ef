#include "plastica/report/web/packed_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

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
  return std::ranges::equal(
      a, b, [spots](double x, double y) { return std::floor(spots * x) == std::floor(spots * y); });
}

/// Distance of a point from the straight line between two others.
double off_chord(const std::vector<double>& point, const std::vector<double>& from,
                 const std::vector<double>& to) {
  double along = 0.0;
  double length = 0.0;
  for (std::size_t c = 0; c < point.size(); ++c) {
    along += (point[c] - from[c]) * (to[c] - from[c]);
    length += (to[c] - from[c]) * (to[c] - from[c]);
  }
  const double at = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  double square = 0.0;
  for (std::size_t c = 0; c < point.size(); ++c) {
    const double off = point[c] - from[c] - at * (to[c] - from[c]);
    square += off * off;
  }
  return std::sqrt(square);
}

/// Marks the points of a stretch without gaps that its line needs, its ends among them.
/// @param first, last  of the stretch, the last one included
void keep_line(const std::vector<std::vector<double>>& points, std::size_t first, std::size_t last,
               double within, std::vector<bool>& keeps) {
  keeps[first] = keeps[last] = true;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{first, last}};
  while (!parts.empty()) {
    const auto [from, to] = parts.back();
    parts.pop_back();
    double largest = within;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double off = off_chord(points[i], points[from], points[to]);
      if (off > largest) {
        largest = off;
        at = i;
      }
    }
    if (at == from) continue;
    keeps[at] = true;
    parts.emplace_back(from, at);
    parts.emplace_back(at, to);
  }
}

using Rows = std::vector<std::vector<double>>;

/// Without those that fall on the spot of the one before; the last one stays.
Rows without_repeated(Rows points, double spots) {
  Rows kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool repeats = !kept.empty() && same_spot(kept.back(), points[i], spots);
    if (!repeats || i + 1 == points.size()) kept.push_back(std::move(points[i]));
  }
  return kept;
}

/// Without those that its line does not need.
Rows line_of(Rows points, double spots) {
  std::vector<bool> keeps(points.size(), false);
  for (std::size_t first = 0; first < points.size(); ++first) {
    if (is_gap(points[first])) {
      keeps[first] = true;
      continue;
    }
    std::size_t last = first;
    while (last + 1 < points.size() && !is_gap(points[last + 1])) ++last;
    keep_line(points, first, last, 0.5 / spots, keeps);
    first = last;
  }
  Rows kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keeps[i]) kept.push_back(std::move(points[i]));
  }
  return kept;
}

}  // namespace

Json packed_points(const Rows& points, std::array<bool, 2> logarithmic, int spots,
                   Thinning thinning) {
  const std::size_t width = points.empty() ? 0 : points.front().size();
  std::vector<Column> columns(width);
  for (std::size_t c = 0; c < width; ++c) {
    columns[c].logarithmic = logarithmic[c == 0 ? 0 : 1];
    for (const auto& point : points) columns[c].enclose(point[c]);
  }
  Rows fractions(points.size(), std::vector<double>(width));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t c = 0; c < width; ++c) fractions[i][c] = columns[c].fraction(points[i][c]);
  }
  if (spots > 0) {
    // A line first without what not even a screen of four times as many spots shows.
    const bool line = thinning == Thinning::Line;
    fractions = without_repeated(std::move(fractions), line ? 4.0 * spots : spots);
    if (line) fractions = line_of(std::move(fractions), spots);
  }
  Json low = Json::array();
  Json high = Json::array();
  Json texts = Json::array();
  for (std::size_t c = 0; c < width; ++c) {
    std::vector<std::uint16_t> steps;
    steps.reserve(fractions.size());
    for (const auto& row : fractions) {
      steps.push_back(is_gap(row) ? kGap
                                  : static_cast<std::uint16_t>(std::lround(kSteps * row[c])));
    }
    low.push_back(number(columns[c].low));
    high.push_back(number(columns[c].high));
    texts.push_back(base64(steps));
  }
  Json packed = {{"n", fractions.size()}, {"low", std::move(low)}, {"high", std::move(high)}};
  if (logarithmic[0] || logarithmic[1]) packed["logarithmic"] = {logarithmic[0], logarithmic[1]};
  packed["columns"] = std::move(texts);
  return packed;
}

}  // namespace plastica::report
