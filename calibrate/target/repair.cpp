#include "calibrate/target/repair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "calibrate/target/characteristics.hpp"
#include "calibrate/target/samples.hpp"

namespace plastica::calibrate {

RawFacts drop_missing(Target& target) {
  target.corrected = target.raw;
  Curve& curve = target.corrected;
  const std::size_t n = curve.size();
  const StrainEnd end = strain_end(curve);
  std::fill(curve.strain.begin() + static_cast<std::ptrdiff_t>(end.measured), curve.strain.end(),
            std::numeric_limits<double>::quiet_NaN());
  RawFacts facts;
  facts.strain_end = end;
  facts.largest_stress = -std::numeric_limits<double>::infinity();
  std::size_t end_of_strain = 0;  // one past the last row with a strain
  bool all_finite = true;
  for (std::size_t i = 0; i < n; ++i) {
    const bool has_strain = std::isfinite(curve.strain[i]);
    const bool has_stress = std::isfinite(curve.stress[i]);
    if (has_strain) end_of_strain = i + 1;
    all_finite = all_finite && has_strain && has_stress;
    if (has_stress && curve.stress[i] > facts.largest_stress) {
      facts.largest_stress = curve.stress[i];
      facts.largest_has_strain = has_strain;
    }
  }
  if (!all_finite) {
    std::size_t removed = 0;
    bool is_loaded = false;
    for (std::size_t i = end_of_strain; i < n; ++i) {
      removed += std::isfinite(curve.stress[i]) ? 1 : 0;
      is_loaded = is_loaded || curve.stress[i] >= kLoaded * facts.largest_stress;
    }
    facts.extensometer_removed = end_of_strain > 0 && is_loaded;
    if (!facts.extensometer_removed) removed = 0;
    drop_missing(samples_of(target), removed);
    note_repair(target.repairs, "extensometer-removed", removed,
                end.measured < n
                    ? "rows at the end have a strain that stands still while the load goes "
                      "on; Rm is taken from them too"
                    : "rows at the end have stress but no strain; Rm is taken from them too");
  }
  drop_duplicates(samples_of(target));
  return facts;
}

std::string too_many_dropped(const Target& target) {
  constexpr std::array<std::string_view, 7> kDrops{
      "nan-rows",        "outliers",  "spikes",          "foot-reversals",
      "unloading-loops", "unloading", "strain-reversals"};
  constexpr double kMany = 0.2;
  if (target.loading == Loading::Cyclic) return {};
  std::size_t dropped = 0;
  std::string rules;
  for (const Repair& repair : target.repairs) {
    if (std::ranges::find(kDrops, repair.kind) == kDrops.end()) continue;
    dropped += repair.count;
    rules += (rules.empty() ? "" : ", ") + repair.kind + " " + std::to_string(repair.count);
  }
  const auto all = static_cast<double>(target.raw.samples());
  const double fraction = static_cast<double>(dropped) / std::max(all, 1.0);
  if (!(fraction > kMany)) return {};
  return fmt::format(
      "{:.0f} % of the samples were dropped ({}), as the curve is taken for one "
      "monotonic test: if it is a cyclic one, say loading = \"cyclic\"",
      100.0 * fraction, rules);
}

Loading find_loading(const Curve& curve) {
  if (curve.size() == 0) return Loading::Monotonic;
  const std::vector<double> stresses =
      medians_of_three(curve.stress);  // lone outliers turn nothing
  double largest = 0.0;
  for (const double stress : stresses) largest = std::max(largest, std::abs(stress));
  const auto [low, high] = std::minmax_element(curve.strain.begin(), curve.strain.end());
  double peak = 0.0;  // of |stress| since the last turn
  std::size_t at = 0;
  std::size_t least = 0;  // of the stress since the peak
  bool unloaded = false;
  int reversed = 0;
  int loops = 0;
  double back = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double magnitude = std::abs(stresses[i]);
    if (magnitude >= peak && !unloaded) {
      peak = magnitude;
      at = least = i;
    }
    if (peak < 0.5 * largest) continue;  // settling cycles
    const double sign = stresses[at] < 0.0 ? -1.0 : 1.0;
    const double stress = sign * stresses[i];
    if (stress < sign * stresses[least]) least = i;
    if (stress < 0.5 * peak && sign * (curve.strain[i] - curve.strain[at]) < 0.0) unloaded = true;
    if (!unloaded) continue;
    if (stress < -0.1 * largest && ++reversed >= 2) return Loading::Cyclic;
    if (stress > 0.5 * peak) {
      ++loops;
      back += std::abs(curve.strain[at] - curve.strain[least]);
      unloaded = false;
      peak = magnitude;
      at = least = i;
    }
  }
  return loops >= 3 && back > *high - *low ? Loading::Cyclic : Loading::Monotonic;
}

void drop_foot_reversals(Target& target, double tolerance) {
  Curve& curve = target.corrected;
  if (curve.size() == 0) return;
  const double foot = 0.2 * *std::max_element(curve.stress.begin(), curve.stress.end());
  std::size_t least = 0;
  double reached = curve.strain[0];
  double back = 0.0;
  for (std::size_t i = 0; i < curve.size() && curve.stress[i] < foot; ++i) {
    if (curve.strain[i] <= curve.strain[least]) least = i;
    reached = std::max(reached, curve.strain[i]);
    if (least == i) back = reached - curve.strain[i];
  }
  if (back <= tolerance) return;
  const auto cut = static_cast<std::ptrdiff_t>(least);
  curve.strain.erase(curve.strain.begin(), curve.strain.begin() + cut);
  curve.stress.erase(curve.stress.begin(), curve.stress.begin() + cut);
  note_repair(target.repairs, "foot-reversals", least,
              "samples at the foot dropped, where the strain ran backwards under a rising load");
}

void drop_unloading_loops(Target& target, const TargetOptions& options) {
  const Curve before = target.corrected;
  const std::vector<double>& strain = before.strain;
  const std::vector<double>& stress = before.stress;
  const std::size_t n = before.size();
  if (n == 0) return;
  const double rm = *std::max_element(stress.begin(), stress.end());
  std::vector<bool> keep(n, true);
  std::size_t top = 0;  // of the strain
  for (std::size_t i = 0; i < n; ++i) {
    const double reached = strain[top] - options.reversal_tolerance;
    if (strain[i] >= reached) {
      if (strain[i] > strain[top]) top = i;
      continue;
    }
    std::size_t end = i;
    double least = stress[top];
    for (; end < n && strain[end] < reached; ++end) least = std::min(least, stress[end]);
    const bool loop = end < n && stress[top] >= 0.5 * rm && stress[top] - least >= 0.1 * rm &&
                      stress[end] >= (1.0 - options.drop_fraction) * stress[top];
    for (std::size_t k = i; loop && k < end; ++k) keep[k] = false;
    i = end - 1;
  }
  const std::size_t dropped = filter(samples_of(target), [&](std::size_t i) { return keep[i]; });
  note_repair(target.repairs, "unloading-loops", dropped,
              "samples of unloading and reloading dropped");
}

bool drop_unloading(Target& target, double modulus, const TargetOptions& options) {
  Curve& curve = target.corrected;
  const std::vector<double>& strain = curve.strain;
  const std::vector<double>& stress = curve.stress;
  const std::size_t n = curve.size();
  const double rm = *std::max_element(stress.begin(), stress.end());
  std::size_t top = 0;
  for (std::size_t i = 1; i < n; ++i) top = strain[i] >= strain[top] ? i : top;
  if (stress[top] < 0.5 * rm) return false;
  std::size_t end = top;
  for (std::size_t i = top + 1; i < n && stress[end] > options.zero_fraction * rm; ++i) {
    if (stress[i] < stress[end]) end = i;
  }
  const double fall = stress[top] - stress[end];
  const double back = strain[top] - strain[end];
  if (end < top + 3 || fall < 0.1 * rm || !(back > options.reversal_tolerance)) return false;
  const double slope = fall / back;
  if (slope < 0.5 * modulus || slope > 1.5 * modulus) return false;
  for (std::size_t i = top + 1; i <= end; ++i) {
    const double off = stress[top] - stress[i] - slope * (strain[top] - strain[i]);
    if (std::abs(off) > 0.15 * fall || stress[i - 1] - stress[i] > 0.5 * fall) return false;
  }
  curve.strain.resize(top + 1);
  curve.stress.resize(top + 1);
  note_repair(target.repairs, "unloading", n - top - 1,
              "samples of elastic unloading at the end dropped");
  return true;
}

}  // namespace plastica::calibrate
