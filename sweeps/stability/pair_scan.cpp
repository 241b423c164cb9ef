#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sweeps/stability/scan_work.hpp"
#include "sweeps/stability/scene_scan.hpp"

namespace plastica::sweeps::stability {
namespace {

/// Values of a grid on either side of the scene's own.
constexpr int kGridValues = 5;

/// Where a grid ends in a direction: a step beyond the first value that is not valid.
double grid_end(double own, const ScanLimit& limit) {
  if (limit.end != ScanEnd::Verdict) return limit.value;
  return limit.next * (std::fabs(limit.next) > std::fabs(own) ? kStep : 1.0 / kStep);
}

/// Values from one end to the other, the scene's own among them, on either side evenly in factors.
std::vector<double> grid_values(const ScannedField& of) {
  const double own = of.value;
  std::vector<double> values;
  const auto add = [&](double end, int k) {
    const double part = static_cast<double>(k) / kGridValues;
    const double value = whole_value(*of.field, own * std::pow(end / own, part));
    const bool known = std::find(values.begin(), values.end(), value) != values.end();
    if (of.field->range.contains(value) && !known) values.push_back(value);
  };
  for (int k = kGridValues; k > 0; --k) add(grid_end(own, of.below), k);
  for (int k = 0; k <= kGridValues; ++k) add(grid_end(own, of.above), k);
  return values;
}

}  // namespace

PairScan scan_pair(const std::string& name, const Setup& setup, const ScannedField& first,
                   const ScannedField& second, const SceneScanOptions& options) {
  PointRunner runner(setup, options);
  runner.run_own();
  const std::vector<double> a = grid_values(first);
  const std::vector<double> b = grid_values(second);
  std::vector<StabilityRow> rows(a.size() * b.size());
  std::vector<char> done(rows.size(), 0);  // left out, or in its row
  PointCounter counter(options);
  const auto take = [&](std::size_t i, Source source) {
    const double x = a[i / b.size()];
    const double y = b[i % b.size()];
    Setup at = setup;
    std::optional<JudgedRun> run;
    try {
      set_field(at, *first.field, x);
      set_field(at, *second.field, y);
      done[i] = runner.work(at) > options.max_work * runner.own_work() ? 1 : 0;
      if (done[i] != 0) return;
      run = runner.run(at, source);
    } catch (const InputError& error) {
      run = refused(error);
    }
    if (!run) return;
    rows[i] = point_row(name, at, {scanned(*first.field, x), scanned(*second.field, y)}, *run);
    done[i] = 1;
    if (source == Source::Run) counter.count();
  };
  PairScan pair;
  pair.complete =
      share_points(rows.size(), options, take, [&](std::size_t i) { return done[i] != 0; });
  std::erase_if(rows, [](const StabilityRow& row) { return !row.begun; });
  pair.rows = std::move(rows);
  return pair;
}

}  // namespace plastica::sweeps::stability
