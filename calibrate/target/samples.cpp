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

void average_reversals(const Samples& samples, std::string_view name) {
  struct Pool {
    double abscissa, ordinate;  ///< sums
    std::size_t count, first;
    double mean() const { return abscissa / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Pool pool{samples.abscissa[i], samples.ordinate[i], 1, i};
    for (; !pools.empty() && pool.mean() < pools.back().mean(); pools.pop_back()) {
      const Pool& before = pools.back();
      pool = {before.abscissa + pool.abscissa, before.ordinate + pool.ordinate,
              before.count + pool.count, before.first};
    }
    pools.push_back(pool);
  }
  std::size_t averaged = 0;
  for (std::size_t k = 0; k < pools.size(); ++k) {
    const Pool& pool = pools[k];
    samples.abscissa[k] = pool.mean();
    samples.ordinate[k] = pool.ordinate / static_cast<double>(pool.count);
    if (samples.rows != nullptr) (*samples.rows)[k] = (*samples.rows)[pool.first];
    if (pool.count > 1) averaged += pool.count;
  }
  samples.abscissa.resize(pools.size());
  samples.ordinate.resize(pools.size());
  if (samples.rows != nullptr) samples.rows->resize(pools.size());
  note_repair(samples.repairs, std::string(name) + "-reversals", averaged,
              "samples averaged where the " + std::string(name) + " ran backwards");
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
