#include "calibrate/target/samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
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

/// Pools of a path that goes to and fro: what turns round by more than the tolerance is its way.
std::vector<Pool> pools_between_turns(const Samples& samples, double tolerance) {
  const std::vector<double>& x = samples.abscissa;
  std::vector<Pool> pools;
  std::size_t begin = 0, low = 0, high = 0;
  double way = 0.0;  // not known yet
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] > x[high]) high = i;
    if (x[i] < x[low]) low = i;
    const bool falls = way >= 0.0 && x[i] < x[high] - tolerance;
    const bool rises = way <= 0.0 && x[i] > x[low] + tolerance;
    if (!falls && !rises) continue;
    const std::size_t turn = falls ? high : low;
    if (way != 0.0 || turn > 0) {
      pool_part(samples, begin, turn + 1, way != 0.0 ? way : (falls ? 1.0 : -1.0), pools);
      begin = turn + 1;
    }
    way = falls ? -1.0 : 1.0;
    low = high = i;
  }
  pool_part(samples, begin, x.size(), way != 0.0 ? way : 1.0, pools);
  return pools;
}

}  // namespace

void average_reversals(const Samples& samples, std::string_view name) {
  std::vector<Pool> pools;
  pool_part(samples, 0, samples.size(), 1.0, pools);
  take_pools(samples, pools, name);
}

void average_small_reversals(const Samples& samples, double tolerance, std::string_view name) {
  take_pools(samples, pools_between_turns(samples, tolerance), name);
}

std::size_t reversed_by_noise(const Samples& samples, double& noise) {
  constexpr double kNoise = 8.0, kSmall = 0.05;
  if (samples.size() == 0) return 0;
  std::vector<double> rows(samples.size());
  std::iota(rows.begin(), rows.end(), 0.0);
  noise = noise_of(rows, samples.abscissa);
  const auto [low, high] = std::ranges::minmax_element(samples.abscissa);
  // Waves of few samples look as noise does.
  if (!(noise > 0.0 && kNoise * noise < kSmall * (*high - *low))) return 0;
  return averaged_in(pools_between_turns(samples, kNoise * noise));
}

void mend_reversals(const Samples& samples, double tolerance, std::string_view name) {
  std::vector<double> rows(samples.size());
  std::iota(rows.begin(), rows.end(), 0.0);
  // What falls back further than noise does is of the test: a slip, a loop, a pause.
  constexpr double kNoise = 8.0;
  const double far = std::max(tolerance, kNoise * noise_of(rows, samples.abscissa));
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
