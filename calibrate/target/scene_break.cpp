#include "calibrate/target/scene_break.hpp"

#include <algorithm>
#include <cmath>

#include "calibrate/target/find_break.hpp"

namespace plastica::calibrate {
namespace {

using Mode = CorrectionChoice::Mode;

/// Samples up to the first beyond an abscissa.
std::optional<std::size_t> intact_up_to(const SceneTarget& target, double abscissa) {
  const auto beyond = std::ranges::find_if(
      target.abscissa, [&](double x) { return abscissa < 0.0 ? x < abscissa : x > abscissa; });
  const auto intact = static_cast<std::size_t>(beyond - target.abscissa.begin());
  if (intact == 0 || intact == target.abscissa.size()) return std::nullopt;
  return intact;
}

/// Whether the step to a sample lets the beam go: towards zero, or against the ordinate, as when a
/// cycle ends on its way through zero. Which way the ordinate acts is told by the work until there,
/// of which a beam takes more than it gives.
bool is_let_go(const SceneTarget& target, std::size_t sample, double tolerance) {
  const std::vector<double>& x = target.abscissa;
  const std::vector<double>& y = target.ordinate;
  if (std::abs(x[sample]) < std::abs(x[sample - 1]) - tolerance) return true;
  double work = 0.0;
  for (std::size_t i = 1; i < sample; ++i) work += 0.5 * (y[i] + y[i - 1]) * (x[i] - x[i - 1]);
  const double step = x[sample] - x[sample - 1];
  return std::abs(step) > tolerance && work * y[sample - 1] * step < 0.0;
}

}  // namespace

std::optional<std::size_t> intact_samples(const SceneTarget& target, const CorrectionChoice& trim,
                                          double tolerance) {
  if (trim.mode == Mode::Off) return std::nullopt;
  if (trim.mode == Mode::Set) return intact_up_to(target, trim.amount);
  const std::vector<double>& y = target.ordinate;
  double largest = 0.0;
  for (const double value : y) largest = std::max(largest, std::abs(value));
  std::size_t intact = y.size();
  while (intact > 0 && std::abs(y[intact - 1]) <= kBreakZero * largest) --intact;
  const std::size_t fallen = y.size() - intact;
  if (fallen == 0 || intact < 2) return std::nullopt;
  const double fall = std::abs(y[intact - 1] - y[intact]);
  if (target.kind == Abscissa::Time) {
    const bool zeros = std::all_of(y.begin() + static_cast<std::ptrdiff_t>(intact), y.end(),
                                   [](double value) { return value == 0.0; });
    if (fall < 0.5 * largest || !(zeros || fallen >= 3)) return std::nullopt;
    return intact;
  }
  if (fall < kBreakDrop * largest || is_let_go(target, intact, tolerance)) return std::nullopt;
  return intact;
}

void cut_at_break(SceneTarget& target, const CorrectionChoice& trim, double tolerance) {
  const std::optional<std::size_t> intact = intact_samples(target, trim, tolerance);
  if (!intact) return;
  double last = target.abscissa[*intact - 1];
  double next = target.abscissa[*intact];
  double step = step_before(target.abscissa, *intact - 1);
  if (!is_driven(target.kind)) {
    const auto end = target.abscissa.begin() + static_cast<std::ptrdiff_t>(*intact);
    last = *std::max_element(target.abscissa.begin(), end);
    step = std::max(step, 0.0);
  }
  // Time goes on by itself, and a place that is set cuts where the load goes on.
  const bool is_found = trim.mode == Mode::Automatic && target.kind != Abscissa::Time;
  constexpr double kStill = 0.1;  // of a step: what is driven moves by less
  if (is_driven(target.kind)) {
    if (is_found && std::abs(next - last) < kStill * std::abs(step)) next = last + step;
  } else {
    next = is_found ? end_of_break(last, next, step, kStill) : std::max(last, next);
  }
  const double half = 0.5 * (next - last);
  target.broke = SceneBreak{
      .at = last + half, .half_interval = std::abs(half), .cut = target.abscissa.size() - *intact};
  target.abscissa.resize(*intact);
  target.ordinate.resize(*intact);
}

}  // namespace plastica::calibrate
