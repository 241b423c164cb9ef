#include "calibrate/target/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "calibrate/target/characteristics.hpp"

namespace plastica::calibrate {

Samples samples_of(Target& target) {
  return {target.corrected.strain, target.corrected.stress, target.repairs};
}

void note_repair(std::vector<Repair>& repairs, std::string_view kind, std::size_t count,
                 std::string_view what) {
  if (count == 0) return;
  repairs.push_back({std::string(kind), count, std::to_string(count) + ' ' + std::string(what)});
}

void report_torn_row(const io::CsvTable& table, std::vector<Repair>& repairs) {
  note_repair(repairs, "comment-rows", table.commented_rows(),
              "rows that begin with #, % or // are taken for comments");
  if (!table.torn_last_row()) return;
  repairs.push_back({"torn-last-row", 1, "the last row was cut off and is dropped"});
}

void warn_of_percent(const io::FoundColumn& column, std::span<const double> strains,
                     std::vector<std::string>& warnings) {
  if (column.has_unit) return;
  const bool beyond = std::ranges::any_of(
      strains, [](double strain) { return std::isfinite(strain) && std::abs(strain) > 1.0; });
  if (beyond) {
    warnings.emplace_back("strains above 100 %: if they are in percent, write unit = \"%\"");
  }
}

void warn_of_unit(const io::CsvTable& table, const io::FoundColumn& column,
                  std::vector<std::string>& warnings) {
  if (column.overridden.empty()) return;
  warnings.push_back("\"" + table.names()[column.index] + "\" is not taken in its file's unit, " +
                     column.overridden + ", as you say (override_unit = true, --override-unit)");
}

void drop_missing(const Samples& samples, std::size_t reported) {
  const std::size_t dropped = filter(samples, [&](std::size_t i) {
    return std::isfinite(samples.abscissa[i]) && std::isfinite(samples.ordinate[i]);
  });
  note_repair(samples.repairs, "nan-rows", dropped - reported,
              "rows dropped that lack one of the two numbers");
}

void drop_duplicates(const Samples& samples) {
  double x = std::numeric_limits<double>::quiet_NaN();
  double y = x;
  const std::size_t dropped = filter(samples, [&](std::size_t i) {
    if (samples.abscissa[i] == x && samples.ordinate[i] == y) return false;
    x = samples.abscissa[i];
    y = samples.ordinate[i];
    return true;
  });
  note_repair(samples.repairs, "duplicates", dropped, "samples equal to the one before dropped");
}

std::vector<double> medians_of_three(std::span<const double> values) {
  std::vector<double> out(values.begin(), values.end());
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const auto [low, high] = std::minmax(values[i - 1], values[i]);
    out[i] = std::clamp(values[i + 1], low, high);
  }
  return out;
}

namespace {

/// Samples that were averaged to one.
struct Pool {
  double abscissa, ordinate;  ///< sums
  std::size_t count, first;
  double mean() const { return abscissa / static_cast<double>(count); }
};

/// Pools samples of a part whose abscissa rises (way 1) or falls (way -1) but for noise, until it
/// does; those before the part stay as they are.
void pool_part(const Samples& samples, std::size_t begin, std::size_t end, double way,
               std::vector<Pool>& pools) {
  const std::size_t before = pools.size();
  for (std::size_t i = begin; i < end; ++i) {
    Pool pool{samples.abscissa[i], samples.ordinate[i], 1, i};
    for (; pools.size() > before && way * pool.mean() < way * pools.back().mean();
         pools.pop_back()) {
      const Pool& last = pools.back();
      pool = {last.abscissa + pool.abscissa, last.ordinate + pool.ordinate, last.count + pool.count,
              last.first};
    }
    pools.push_back(pool);
  }
}

/// Of how many samples the pools of more than one are.
std::size_t averaged_in(std::span<const Pool> pools) {
  std::size_t averaged = 0;
  for (const Pool& pool : pools) averaged += pool.count > 1 ? pool.count : 0;
  return averaged;
}

void take_pools(const Samples& samples, std::span<const Pool> pools, std::string_view name) {
  for (std::size_t k = 0; k < pools.size(); ++k) {
    const Pool& pool = pools[k];
    samples.abscissa[k] = pool.mean();
    samples.ordinate[k] = pool.ordinate / static_cast<double>(pool.count);
    if (samples.rows != nullptr) (*samples.rows)[k] = (*samples.rows)[pool.first];
  }
  samples.abscissa.resize(pools.size());
  samples.ordinate.resize(pools.size());
  if (samples.rows != nullptr) samples.rows->resize(pools.size());
  note_repair(samples.repairs, std::string(name) + "-reversals", averaged_in(pools),
              "samples averaged where the " + std::string(name) + " ran backwards");
}

/// Where the parts of a path end that goes to and fro: at turns by more than the tolerance.
struct Turns {
  std::vector<std::size_t> ends;  ///< one past the last sample of each part
  double first_way = 1.0;         ///< whether the first one rises (1) or falls (-1)
};

Turns turns_of(std::span<const double> x, double tolerance) {
  Turns turns;
  std::size_t low = 0, high = 0;
  double way = 0.0;  // not known yet
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] > x[high]) high = i;
    if (x[i] < x[low]) low = i;
    const bool falls = way >= 0.0 && x[i] < x[high] - tolerance;
    const bool rises = way <= 0.0 && x[i] > x[low] + tolerance;
    if (!falls && !rises) continue;
    const std::size_t turn = falls ? high : low;
    // What lies within the tolerance of the first sample is no part of its own.
    const bool is_first = way == 0.0 && std::abs(x[turn] - x[0]) <= tolerance;
    if (!is_first) turns.ends.push_back(turn + 1);
    if (way == 0.0) turns.first_way = is_first == falls ? -1.0 : 1.0;
    way = falls ? -1.0 : 1.0;
    low = high = i;
  }
  turns.ends.push_back(x.size());
  return turns;
}

/// Pools a turn with what lies beside it, as long as noise may part them by three standard errors:
/// of a hold the turn is the sample that noise took furthest.
/// @param turn  its pool
void pool_turn(std::vector<Pool>& pools, std::size_t turn, double noise) {
  const auto distance = [&](std::size_t k) {
    const double both =
        1.0 / static_cast<double>(pools[k].count) + 1.0 / static_cast<double>(pools[turn].count);
    return std::abs(pools[k].mean() - pools[turn].mean()) / (3.0 * noise * std::sqrt(both));
  };
  constexpr double kFar = std::numeric_limits<double>::infinity();
  while (noise > 0.0) {
    // The first pool is where the path begins.
    const double before = turn > 1 ? distance(turn - 1) : kFar;
    const double behind = turn + 1 < pools.size() ? distance(turn + 1) : kFar;
    if (std::min(before, behind) > 1.0) return;
    if (before <= behind) --turn;
    Pool& into = pools[turn];
    const Pool& other = pools[turn + 1];
    into = {into.abscissa + other.abscissa, into.ordinate + other.ordinate,
            into.count + other.count, into.first};
    pools.erase(pools.begin() + static_cast<std::ptrdiff_t>(turn) + 1);
  }
}

/// Pools of a path that goes to and fro: what turns round by more than the tolerance is of the
/// path.
std::vector<Pool> pools_between_turns(const Samples& samples, double tolerance, double noise) {
  const Turns turns = turns_of(samples.abscissa, tolerance);
  std::vector<Pool> pools;
  std::vector<std::size_t> last;  // pool of each part
  std::size_t begin = 0;
  double way = turns.first_way;
  for (const std::size_t end : turns.ends) {
    pool_part(samples, begin, end, way, pools);
    last.push_back(pools.size() - 1);
    begin = end;
    way = -way;
  }
  // From the end, so that the numbers of those before stay.
  for (std::size_t part = last.size(); part-- > 1;) pool_turn(pools, last[part - 1], noise);
  return pools;
}

/// Whether what moves samples to and fro is noise: then the steps between them, less what their
/// neighbours have in common, are alike by -1/2 from one to the next, and no further. Those of
/// waves of n samples are so by cos(2 pi/n) and cos(4 pi/n).
bool moves_by_noise(std::span<const double> x) {
  constexpr std::size_t kReach = 4;
  if (x.size() < 4 * kReach) return false;
  std::vector<double> steps(x.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = x[i + 1] - x[i];
  std::vector<double> left, near;
  for (std::size_t i = kReach; i + kReach < steps.size(); ++i) {
    const auto at = steps.begin() + static_cast<std::ptrdiff_t>(i);
    near.assign(at - kReach, at + kReach + 1);
    std::ranges::nth_element(near, near.begin() + kReach);
    left.push_back(*at - near[kReach]);
  }
  double squares = 0.0, next = 0.0, second = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    squares += left[i] * left[i];
    if (i + 1 < left.size()) next += left[i] * left[i + 1];
    if (i + 2 < left.size()) second += left[i] * left[i + 2];
  }
  return next < -0.3 * squares && next > -0.7 * squares && std::abs(second) < 0.25 * squares;
}

}  // namespace

void average_reversals(const Samples& samples, std::string_view name) {
  std::vector<Pool> pools;
  pool_part(samples, 0, samples.size(), 1.0, pools);
  take_pools(samples, pools, name);
}

void average_small_reversals(const Samples& samples, double tolerance, std::string_view name) {
  // Within the tolerance, which is to be some times the noise.
  const double noise = std::min(noise_over_rows(samples.abscissa), tolerance);
  take_pools(samples, pools_between_turns(samples, tolerance, noise), name);
}

std::size_t reversed_by_noise(const Samples& samples, double& noise) {
  constexpr std::size_t kFew = 10;
  constexpr double kMany = 0.05;
  noise = noise_over_rows(samples.abscissa);
  if (!(noise > 0.0) || !moves_by_noise(samples.abscissa)) return 0;
  const std::size_t reversed = averaged_in(pools_between_turns(samples, kNoises * noise, 0.0));
  const double fraction = static_cast<double>(reversed) / static_cast<double>(samples.size());
  return reversed >= kFew && fraction >= kMany ? reversed : 0;
}

void mend_reversals(const Samples& samples, double tolerance, std::string_view name) {
  // What falls back further than noise does is of the test: a slip, a loop, a pause.
  const double far = std::max(tolerance, kNoises * noise_over_rows(samples.abscissa));
  double reached = -std::numeric_limits<double>::infinity();
  const std::size_t dropped = filter(samples, [&](std::size_t i) {
    if (samples.abscissa[i] < reached - far) return false;
    reached = std::max(reached, samples.abscissa[i]);
    return true;
  });
  note_repair(samples.repairs, std::string(name) + "-reversals", dropped,
              "samples dropped where the " + std::string(name) + " ran backwards");
  double most = 0.0;
  reached = -std::numeric_limits<double>::infinity();
  for (const double value : samples.abscissa) {
    reached = std::max(reached, value);
    most = std::max(most, reached - value);
  }
  if (most > tolerance) average_reversals(samples, name);
}

}  // namespace plastica::calibrate
