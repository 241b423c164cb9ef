#include "calibrate/target/scene_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/named_column.hpp"
#include "calibrate/target/named_measure.hpp"
#include "calibrate/target/samples.hpp"
#include "calibrate/target/scene_break.hpp"
#include "calibrate/trial/scene_drive.hpp"

namespace plastica::calibrate {
namespace {

/// The first sample further than the tolerance below the largest before it; all: none is.
std::size_t first_back(std::span<const double> values, double tolerance) {
  double reached = -std::numeric_limits<double>::infinity();
  std::size_t i = 0;
  for (; i < values.size() && values[i] >= reached - tolerance; ++i) {
    reached = std::max(reached, values[i]);
  }
  return i;
}

bool goes_one_way(std::vector<double> values, double tolerance) {
  if (first_back(values, tolerance) == values.size()) return true;
  for (double& value : values) value = -value;
  return first_back(values, tolerance) == values.size();
}

/// The range of the abscissa up to the last sample that carries load: what the sensor does after a
/// break is no part of it.
double loaded_range(const SceneTarget& target) {
  const double least = kBreakZero * largest_magnitude(target.ordinate);
  std::size_t loaded = target.ordinate.size();
  while (loaded > 1 && std::abs(target.ordinate[loaded - 1]) <= least) --loaded;
  const auto [low, high] = std::ranges::minmax_element(std::span(target.abscissa).first(loaded));
  return *high - *low;
}

/// Refuses rows without an ordinate where the path that a scene follows has a corner: left out,
/// they would change the path.
void refuse_lost_corner(const io::CsvTable& table, std::size_t column, const SceneTarget& target) {
  const std::vector<double>& x = target.abscissa;
  const auto is_whole = [&](std::size_t i) {
    return std::isfinite(x[i]) && std::isfinite(target.ordinate[i]);
  };
  double before = 0.0;  // where the scene begins
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (is_whole(i)) {
      before = x[i];
      continue;
    }
    std::size_t next = i;
    while (next < x.size() && !is_whole(next)) ++next;
    if (next == x.size()) return;  // the path ends before
    const auto [low, high] = std::minmax(before, x[next]);
    for (; i < next; ++i) {
      if (!std::isfinite(x[i]) || (x[i] >= low && x[i] <= high)) continue;
      throw InputError({table.file(), table.line_of_row(i)}, table.label(column),
                       table.cell(i, column),
                       "has no ordinate where the path turns: a scene that follows this column "
                       "would not go there");
    }
    before = x[next];
  }
}

/// A scene follows what it is driven by, noise as well: each step back unloads it, and each peak
/// makes it flow.
void mend_driven(const SceneTargetSource& source, const Samples& samples, SceneTarget& target) {
  if (source.reversal_tolerance) {
    average_small_reversals(samples, *source.reversal_tolerance, "abscissa");
    return;
  }
  double noise = 0.0;
  const std::size_t reversed = reversed_by_noise(samples, noise);
  if (reversed == 0) return;
  const std::string_view si = si_unit(target.abscissa_is);
  const std::string unit = si == "1" ? std::string() : ' ' + std::string(si);
  target.warnings.push_back(
      fmt::format("the abscissa runs to and fro by its noise of {:.2g}{} in {} of {} samples, and "
                  "the scene follows it: once it yields, stresses come out too large; "
                  "reversal_tolerance averages what turns round by less, such as {:.2g}{}",
                  noise, unit, reversed, samples.size(), kNoises * noise, unit));
}

}  // namespace

SceneTarget read_scene_target(const SceneTargetSource& source, const Scene& scene,
                              SceneTarget probes) {
  SceneTarget target = std::move(probes);
  const io::CsvTable table = io::CsvTable::read(source.file, source.csv);
  if (target.name.empty()) target.name = std::filesystem::path(source.file).stem().string();
  target.ordinate_is = ordinate_dimension(scene, target);
  target.abscissa_is = abscissa_dimension(scene, target, target.abscissa_where);
  const io::FoundColumn x =
      io::find_column(table, named(source.abscissa, "abscissa"), target.abscissa_is);
  const io::FoundColumn y =
      io::find_column(table, named(source.ordinate, "ordinate"), target.ordinate_is);
  const bool by_name = !std::ranges::all_of(source.abscissa.column,
                                            [](unsigned char c) { return std::isdigit(c) != 0; });
  if (target.kind == Abscissa::Strain && by_name) {
    check_total_strain(table, x.index, "its number in place of its name takes it as it is");
  }
  target.abscissa = io::numbers_of(table, x);
  target.ordinate = io::numbers_of(table, y);
  for (const io::FoundColumn& column : {x, y}) warn_of_unit(table, column, target.warnings);
  if (target.abscissa_is == Dimension::Strain) {
    warn_of_percent(x, target.abscissa, target.warnings);
  }
  std::vector<std::size_t> rows(table.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  const Samples samples{target.abscissa, target.ordinate, target.repairs, &rows};
  report_torn_row(table, target.repairs);
  if (is_driven(target.kind)) refuse_lost_corner(table, x.index, target);
  drop_missing(samples);
  drop_duplicates(samples);
  if (samples.size() == 0) {
    throw InputError({table.file(), 0}, table.label(y.index), "", kNoSamples);
  }
  const double tolerance =
      source.reversal_tolerance.value_or(kReversalFraction * loaded_range(target));
  if (target.kind != Abscissa::Time && goes_one_way(target.abscissa, tolerance)) {
    drop_outliers(samples);
  }
  cut_at_break(target, source.trim, tolerance);
  if (is_driven(target.kind)) {
    mend_driven(source, samples, target);
    return target;
  }
  const std::size_t back = first_back(target.abscissa, tolerance);
  if (back < samples.size()) {
    if (target.kind != Abscissa::Time && goes_one_way(target.abscissa, tolerance)) {
      throw InputError({table.file(), table.line_of_row(rows[back])}, table.label(x.index),
                       table.cell(rows[back], x.index),
                       "falls all the way, and must rise: turn its sign, and set its factor to -1");
    }
    throw InputError({table.file(), table.line_of_row(rows[back])}, table.label(x.index),
                     table.cell(rows[back], x.index),
                     "goes back by more than reversal_tolerance: a beam's curve is followed one "
                     "way; a scene that this column drives follows it to and fro");
  }
  average_reversals(samples, "abscissa");
  return target;
}

}  // namespace plastica::calibrate
