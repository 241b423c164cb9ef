#include "calibrate/target/strain_end.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "plastica/base/median.hpp"

namespace plastica::calibrate {
namespace {

constexpr double kStillWithin = 1e-4;  // of the largest strain
constexpr std::size_t kFewestStill = 8;
constexpr double kLoaded = 0.2;   // of the largest stress
constexpr double kRises = 0.002;  // the same

double finite_magnitude(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The rows at the end whose strain is near one value.
struct StandingRows {
  std::size_t begin = 0;
  double near = 0.0;   // that value, to both sides
  double noise = 0.0;  // of the strain
};

StandingRows standing_rows(std::span<const double> strain) {
  constexpr std::size_t kLast = 30;
  const std::size_t n = strain.size();
  std::vector<double> end(strain.end() - static_cast<std::ptrdiff_t>(std::min(n, kLast)),
                          strain.end());
  StandingRows rows{n};
  if (!std::ranges::all_of(end, [](double one) { return std::isfinite(one); })) return rows;
  rows.noise = noise_over_rows(end);
  rows.near = std::max(kStillWithin * finite_magnitude(strain), 6.0 * rows.noise);
  const double still = value_of_rank(end, end.size() / 2);
  while (rows.begin > 0 && std::abs(strain[rows.begin - 1] - still) <= rows.near) --rows.begin;
  return rows;
}

/// The most rows under load, one after the other, whose strains are as near to each other as
/// standing ones: in a pause, or by the step of a coarse strain.
struct Stays {
  double of_any = 0.0;
  double of_rising = 0.0;  ///< of those in which the load rises
};

/// @param rows  of the record that count
Stays longest_stays(const Curve& raw, std::size_t rows, double near, double largest) {
  Stays longest;
  std::size_t from = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const bool is_loaded = std::abs(raw.stress[i]) >= kLoaded * largest;
    if (!is_loaded || !(std::abs(raw.strain[i] - raw.strain[from]) <= 2.0 * near)) from = i;
    if (!is_loaded) continue;
    const auto stay = static_cast<double>(i - from + 1);
    longest.of_any = std::max(longest.of_any, stay);
    if (std::abs(raw.stress[i]) - std::abs(raw.stress[from]) <= kRises * largest) continue;
    longest.of_rising = std::max(longest.of_rising, stay);
  }
  return longest;
}

/// Whether a row's strain goes on from the one before as those before did.
bool goes_on_at(std::span<const double> strain, std::size_t row, double near) {
  constexpr std::size_t kBefore = 10;
  constexpr double kLonger = 2.0;
  double usual = 0.0;
  for (std::size_t i = row > kBefore ? row - kBefore : 1; i < row; ++i) {
    usual = std::max(usual, std::abs(strain[i] - strain[i - 1]));
  }
  return std::abs(strain[row] - strain[row - 1]) <= kLonger * usual + near;
}

/// How the load goes on from a row to the end of a test.
struct LoadAfter {
  double moves = 0.0;  // from quarter to quarter, not by its noise [Pa]
  bool rises = false;  // at all
};

LoadAfter load_after(const std::vector<double>& stress, double largest) {
  constexpr double kErrors = 5.0;
  constexpr std::size_t kFirst = 5;
  const std::span<const double> all(stress);
  const std::size_t quarter = all.size() / 4;
  double low = largest, high = 0.0;
  for (std::size_t q = 0; q < 4; ++q) {
    const double mean = mean_of(all.subspan(q * quarter, quarter));
    low = std::min(low, mean);
    high = std::max(high, mean);
  }
  const std::size_t first = std::min(kFirst, quarter);
  const double error = noise_over_rows(all) * std::sqrt(1.0 / static_cast<double>(first) +
                                                        1.0 / static_cast<double>(quarter));
  const double rise = high - mean_of(all.first(first));
  return {high - low, rise > std::max(kRises * largest, kErrors * error)};
}

}  // namespace

StrainEnd strain_end(const Curve& raw) {
  constexpr double kOn = 0.5, kMoves = 0.02, kFarLonger = 3.0;
  constexpr std::size_t kMany = 20;
  const std::size_t n = raw.size();
  const StrainEnd measured{n};
  if (n < 2 * kFewestStill) return measured;
  const StandingRows rows = standing_rows(raw.strain);
  const std::size_t begin = rows.begin;
  if (begin == 0 || n - begin < kFewestStill) return measured;
  const double largest = finite_magnitude(raw.stress);
  const double start = std::abs(raw.stress[begin]);
  if (!(start >= kLoaded * largest)) return measured;
  std::vector<double> strain, stress;  // of the rows in which the load goes on
  for (std::size_t i = begin; i < n; ++i) {
    if (std::abs(raw.stress[i]) < kOn * start) continue;
    strain.push_back(raw.strain[i]);
    stress.push_back(std::abs(raw.stress[i]));
  }
  if (strain.size() < kFewestStill) return measured;
  // It stands still if its second half has gone no further than the first: four standard errors.
  const std::size_t half = strain.size() / 2;
  const std::span<const double> all(strain);
  const double gone = mean_of(all.last(half)) - mean_of(all.first(half));
  const double error = rows.noise * std::sqrt(2.0 / static_cast<double>(half));
  const double still = kStillWithin * finite_magnitude(raw.strain);
  if (!(std::abs(gone) <= std::max(still, 4.0 * error))) return measured;
  const auto stands = static_cast<double>(strain.size());
  const Stays before = longest_stays(raw, begin, rows.near, largest);
  const auto is_long = [&](double stay) {
    return strain.size() >= kMany && stands > kFarLonger * stay;
  };
  const LoadAfter load = load_after(stress, largest);
  const bool moves = load.moves > kMoves * largest && stands > before.of_rising;
  if (moves || (load.rises && is_long(before.of_rising))) {
    // The row before has the last strain that was measured, or the first that stands still has.
    return {goes_on_at(raw.strain, begin, rows.near) ? begin + 1 : begin};
  }
  return {n, is_long(before.of_any) ? strain.size() : 0};
}

}  // namespace plastica::calibrate
