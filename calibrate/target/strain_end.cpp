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
constexpr double kRises = 0.002;  // of the largest stress

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

/// The rows under load at the end whose strain is near one value, but for a few that are missing or
/// far off.
struct StandingRows {
  std::size_t begin = 0;
  double still = 0.0;  // that value
  double near = 0.0;   // to both sides of it
  double noise = 0.0;  // of the strain

  bool has(double strain) const { return std::abs(strain - still) <= near; }
};

/// @param end  of the rows under load: a break shakes the strain
StandingRows standing_rows(std::span<const double> strain, std::size_t end) {
  constexpr std::size_t kLast = 30, kFew = 3;
  std::vector<double> last;
  for (std::size_t i = end; i-- > 0 && last.size() < kLast;) {
    if (std::isfinite(strain[i])) last.push_back(strain[i]);
  }
  StandingRows rows;
  rows.begin = end;
  if (last.empty()) return rows;
  rows.noise = noise_over_rows(last);
  rows.near = std::max(kStillWithin * finite_magnitude(strain.first(end)), 6.0 * rows.noise);
  rows.still = value_of_rank(last, last.size() / 2);
  std::size_t missed = 0;
  for (std::size_t i = end; i-- > 0;) {
    if (rows.has(strain[i])) {
      rows.begin = i;
      missed = 0;
    } else if (std::isfinite(strain[i]) && ++missed > kFew) {
      break;
    }
  }
  return rows;
}

/// Whether the second half has gone no further than the first: by four standard errors, or less.
bool stands_still(std::span<const double> strain, double noise, double less) {
  const std::size_t half = strain.size() / 2;
  if (half == 0) return true;
  const double gone = mean_of(strain.last(half)) - mean_of(strain.first(half));
  return std::abs(gone) <= std::max(less, 4.0 * noise * std::sqrt(2.0 / static_cast<double>(half)));
}

/// The most rows under load, one after the other, whose strain stands still before the end: in a
/// pause, or by the step of a coarse strain. Where rows are dense on a steep part it goes on.
struct Stays {
  double of_any = 0.0;
  double of_rising = 0.0;  ///< of those in which the load rises
};

Stays longest_stays(const Curve& raw, const StandingRows& end, double largest) {
  constexpr double kRepeats = 1e-6;  // of the largest strain so far
  const std::span<const double> strain(raw.strain.data(), end.begin);
  const double alike = kRepeats * finite_magnitude(strain);
  const double near = std::max(alike, 6.0 * end.noise);
  Stays longest;
  std::size_t from = 0;
  const auto take = [&](std::size_t behind) {
    if (!stands_still(strain.subspan(from, behind - from), end.noise, alike)) return;
    const auto stay = static_cast<double>(behind - from);
    longest.of_any = std::max(longest.of_any, stay);
    // From half to half, not by its noise.
    const std::size_t half = (behind - from) / 2;
    if (half == 0) return;
    const std::span<const double> stress(raw.stress.data() + from, behind - from);
    const double rise =
        std::abs(mean_of(stress.last(half))) - std::abs(mean_of(stress.first(half)));
    const double error = noise_over_rows(stress) * std::sqrt(2.0 / static_cast<double>(half));
    if (rise <= std::max(kRises * largest, 4.0 * error)) return;
    longest.of_rising = std::max(longest.of_rising, stay);
  };
  for (std::size_t i = 0; i < strain.size(); ++i) {
    const bool is_loaded = std::abs(raw.stress[i]) >= kLoaded * largest;
    if (is_loaded && i > from && std::abs(strain[i] - strain[from]) <= 2.0 * near) continue;
    if (i > from) take(i);
    from = is_loaded ? i : i + 1;
  }
  if (from < strain.size()) take(strain.size());
  return longest;
}

/// Whether a row's strain goes on from the one before as in some rows before.
bool goes_on_at(std::span<const double> strain, std::size_t row, std::size_t before, double near) {
  constexpr double kLonger = 2.0;
  double usual = 0.0;
  for (std::size_t i = row > before ? row - before : 1; i < row; ++i) {
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
  StrainEnd end;
  end.measured = raw.size();
  const double largest = finite_magnitude(raw.stress);
  const auto carries = [&](double least) {
    return [least](double stress) { return std::abs(stress) >= least; };  // NaN does not
  };
  if (!(largest > 0.0)) return end;
  const auto behind =
      std::find_if(raw.stress.rbegin(), raw.stress.rend(), carries(kLoaded * largest));
  const auto loaded = static_cast<std::size_t>(raw.stress.rend() - behind);
  if (loaded < 2 * kFewestStill) return end;
  const StandingRows rows = standing_rows(raw.strain, loaded);
  const std::size_t begin = rows.begin;
  if (begin == 0 || loaded - begin < kFewestStill) return end;
  const auto rest = std::span(raw.stress).subspan(begin);
  const auto first = std::ranges::find_if(rest, carries(0.0));
  if (!(std::abs(*first) >= kLoaded * largest)) return end;
  std::vector<double> strain, stress;  // of the rows in which the load goes on
  std::size_t last = begin;
  for (std::size_t i = begin; i < loaded; ++i) {
    if (!rows.has(raw.strain[i]) || !carries(kOn * std::abs(*first))(raw.stress[i])) continue;
    strain.push_back(raw.strain[i]);
    stress.push_back(std::abs(raw.stress[i]));
    last = i;
  }
  if (strain.size() < kFewestStill) return end;
  const double less = kStillWithin * finite_magnitude(raw.strain);
  if (!stands_still(strain, rows.noise, less)) return end;
  // The fall of a break in rows that are near to each other in time goes on below.
  const bool falls_on = last + 1 < raw.size() && stress.back() < stress.front() &&
                        carries(0.5 * stress.back())(raw.stress[last + 1]);
  if (strain.size() < kMany && falls_on) return end;
  const auto stands = static_cast<double>(strain.size());
  const Stays before = longest_stays(raw, rows, largest);
  const auto is_long = [&](double stay) {
    return strain.size() >= kMany && stands > kFarLonger * stay;
  };
  const LoadAfter load = load_after(stress, largest);
  const bool moves = load.moves > kMoves * largest;
  const auto goes_on = [&](std::size_t rows_before) {
    return goes_on_at(raw.strain, begin, rows_before, rows.near);
  };
  if ((moves && stands > before.of_rising) || (load.rises && is_long(before.of_rising))) {
    // The row before has the last strain that was measured, or the first that stands still has.
    constexpr std::size_t kNext = 10;
    end.measured = goes_on(kNext) ? begin + 1 : begin;
  } else if (is_long(goes_on(3 * strain.size()) ? before.of_any : 0.0)) {
    // No pause begins with a jump, unless it is the step of a coarse strain.
    end.unclear = strain.size();
    end.still = rows.still;
    end.within = rows.near;
  }
  return end;
}

}  // namespace plastica::calibrate
