#include "calibrate/target/find_break.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "calibrate/target/characteristics.hpp"

namespace plastica::calibrate {

double step_before(std::span<const double> path, std::size_t last) {
  constexpr std::size_t kSteps = 4;
  double own = 0.0;   // the last step that went anywhere
  double span = 0.0;  // of those that went the same way
  std::size_t steps = 0;
  for (std::size_t i = last; i > 0 && steps < kSteps; --i) {
    const double step = path[i] - path[i - 1];
    if (step == 0.0) continue;
    if (own == 0.0) own = step;
    if (step * own < 0.0) break;  // it turned there
    span += step;
    ++steps;
  }
  if (steps == 0) return 0.0;
  const double mean = span / static_cast<double>(steps);
  return std::abs(own) > std::abs(mean) ? own : mean;
}

double end_of_break(double reached, double next, double step, double even) {
  if (step == 0.0) return std::max(reached, next);
  return (next - reached) * step < even * step * step ? reached + step : next;
}

BreakFound broken_after(const Curve& curve, std::size_t last, Loading loading, const char* rule) {
  BreakFound found;
  found.intact = last + 1;
  const auto end = curve.strain.begin() + static_cast<std::ptrdiff_t>(last + 1);
  std::vector<double> path(curve.strain.begin(), end);
  // A strain once reached under load was intact, also where it ran back a little since.
  if (loading == Loading::Monotonic) {
    std::partial_sum(path.begin(), path.end(), path.begin(),
                     [](double a, double b) { return std::max(a, b); });
  }
  const double reached = path.back();
  const double next = curve.strain[last + 1];
  // An extensometer springs back by any part of a step as the load goes; of a load that falls in
  // several rows the next one is still of the specimen that breaks, if it goes on at all.
  const bool falls_at_once = std::abs(curve.stress[last + 1]) <= 0.5 * std::abs(curve.stress[last]);
  const double even = falls_at_once ? 0.9 : 1e-6;
  found.observation.last_intact_strain = reached;
  found.observation.last_intact_stress = curve.stress[last];
  found.observation.first_broken_strain =
      end_of_break(reached, next, step_before(path, last), even);
  found.observation.rule = rule;
  return found;
}

namespace {

std::optional<BreakFound> cyclic_break(const Curve& curve, double zero_fraction) {
  const std::size_t n = curve.size();
  double largest = 0.0;
  for (const double stress : curve.stress) largest = std::max(largest, std::abs(stress));
  // The record may go on after the break.
  std::size_t intact = n;
  while (intact > 0 && std::abs(curve.stress[intact - 1]) <= zero_fraction * largest) --intact;
  if (intact == n || intact == 0 || !(std::abs(curve.stress[intact - 1]) > 0.5 * largest)) {
    return std::nullopt;
  }
  return broken_after(curve, intact - 1, Loading::Cyclic, "fall-to-zero");
}

/// Index of Rm for the end of the data: of the largest stress, or, if that is an upper yield point
/// (the stress climbs again after it), of the largest stress after the climb.
std::size_t peak_before_end(const Curve& curve, std::size_t peak, double yield_drop) {
  const auto& stress = curve.stress;
  const double climb =
      std::max(yield_drop * stress[peak], 8.0 * noise_of(curve.strain, curve.stress));
  double low = stress[peak];
  for (std::size_t i = peak; i < stress.size(); ++i) {
    low = std::min(low, stress[i]);
    if (stress[i] - low < climb || climb <= 0.0) continue;
    const auto later = stress.begin() + static_cast<std::ptrdiff_t>(i);
    return static_cast<std::size_t>(std::max_element(later, stress.end()) - stress.begin());
  }
  return peak;
}

/// Whether the line through the second half of the strain from the peak on falls by a quarter of
/// the whole fall: a neck does, a plateau after an upper yield point does not.
bool falls_at_end(const Curve& curve, std::size_t peak) {
  const double end = curve.strain.back();
  const double middle = 0.5 * (curve.strain[peak] + end);
  double count = 0.0;
  double mean_strain = 0.0;
  double mean_stress = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t i = peak; i < curve.size(); ++i) {
    if (curve.strain[i] < middle) continue;
    count += 1.0;
    const double x = curve.strain[i] - mean_strain;
    mean_strain += x / count;
    mean_stress += (curve.stress[i] - mean_stress) / count;
    sxx += x * (curve.strain[i] - mean_strain);
    sxy += x * (curve.stress[i] - mean_stress);
  }
  if (!(sxx > 0.0)) return true;  // one step: all of the fall is at the end
  const double fall = curve.stress[peak] - curve.stress.back();
  return -sxy / sxx * (end - middle) >= 0.25 * fall;
}

}  // namespace

std::optional<BreakFound> find_break(const Curve& curve, Loading loading, double modulus,
                                     bool goes_on, const TargetOptions& options) {
  if (loading == Loading::Cyclic) return cyclic_break(curve, options.zero_fraction);
  const auto& strain = curve.strain;
  const auto& stress = curve.stress;
  const std::size_t n = curve.size();
  if (n < 2) return std::nullopt;
  const auto peak = std::max_element(stress.begin(), stress.end());
  const double rm = *peak;
  const double zero = options.zero_fraction * rm;
  std::vector<double> later = stress;  // largest stress from each sample on
  for (std::size_t i = n - 1; i-- > 0;) later[i] = std::max(later[i], later[i + 1]);
  const auto stays_down = [&](std::size_t from, double before) {
    return later[from] <= std::max((1.0 - options.drop_fraction) * before, 2.0 * zero);
  };
  std::size_t run = static_cast<std::size_t>(peak - stress.begin());  // start of the steep fall
  for (std::size_t i = run; i + 1 < n; ++i) {
    const double fall = stress[i] - stress[i + 1];
    const double step = std::max(0.0, strain[i + 1] - strain[i]);
    if (!(fall > 0.5 * modulus * step)) {
      run = i + 1;
    } else if (stress[run] - stress[i + 1] >= options.drop_fraction * rm &&
               stays_down(i + 1, stress[run])) {
      std::size_t last = run;
      while (stress[last + 1] > (1.0 - options.drop_fraction) * stress[run]) ++last;
      return broken_after(curve, last, loading,
                          stress[i + 1] <= zero ? "fall-to-zero" : "load-drop");
    }
    if (!stays_down(i + 1, stress[i])) continue;
    if (stress[i + 1] <= zero) return broken_after(curve, i, loading, "fall-to-zero");
    if (fall >= 0.5 * rm) return broken_after(curve, i, loading, "load-drop");
  }
  if (goes_on) return std::nullopt;
  const std::size_t top =
      peak_before_end(curve, static_cast<std::size_t>(peak - stress.begin()), options.yield_drop);
  // Who says that the end is the break, whatever the load, need not see it fall.
  const bool is_said = options.end_fraction >= stress[n - 1] / stress[top] &&
                       options.end_fraction > TargetOptions{}.end_fraction;
  if (is_said ||
      (stress[n - 1] <= options.end_fraction * stress[top] && falls_at_end(curve, top))) {
    BreakFound found;
    found.intact = n;
    const double step = std::max(0.0, strain[n - 1] - strain[n - 2]);
    const double reached = *std::max_element(strain.begin(), strain.end());
    found.observation = {reached, stress[n - 1], std::max(reached, strain[n - 1] + step),
                         "end-of-data"};
    return found;
  }
  return std::nullopt;
}

}  // namespace plastica::calibrate
