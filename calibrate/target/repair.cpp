#include "calibrate/target/repair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace plastica::calibrate {
namespace {

void report(Target& target, const char* kind, std::size_t count, const char* what) {
  if (count > 0) target.repairs.push_back({kind, count, std::to_string(count) + what});
}

/// Keeps the samples for which keep(i) holds, in order; returns how many were dropped.
template <typename Keep>
std::size_t filter(Curve& curve, Keep keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (!keep(i)) continue;
    if (kept != i) {
      curve.strain[kept] = curve.strain[i];
      curve.stress[kept] = curve.stress[i];
    }
    ++kept;
  }
  const std::size_t dropped = curve.size() - kept;
  curve.strain.resize(kept);
  curve.stress.resize(kept);
  return dropped;
}

}  // namespace

RawFacts drop_missing(Target& target) {
  const Curve& raw = target.raw;
  const std::size_t n = raw.size();
  RawFacts facts;
  facts.largest_stress = -std::numeric_limits<double>::infinity();
  std::size_t end_of_strain = 0;  // one past the last row with a strain
  bool all_finite = true;
  for (std::size_t i = 0; i < n; ++i) {
    const bool has_strain = std::isfinite(raw.strain[i]);
    const bool has_stress = std::isfinite(raw.stress[i]);
    if (has_strain) end_of_strain = i + 1;
    all_finite = all_finite && has_strain && has_stress;
    if (has_stress && raw.stress[i] > facts.largest_stress) {
      facts.largest_stress = raw.stress[i];
      facts.largest_has_strain = has_strain;
    }
  }
  target.corrected = raw;
  if (!all_finite) {
    std::size_t removed = 0;
    for (std::size_t i = end_of_strain; i < n; ++i) removed += std::isfinite(raw.stress[i]) ? 1 : 0;
    facts.extensometer_removed = end_of_strain > 0 && removed > 0;
    if (!facts.extensometer_removed) removed = 0;
    const std::size_t dropped = filter(target.corrected, [&](std::size_t i) {
      return std::isfinite(raw.strain[i]) && std::isfinite(raw.stress[i]);
    });
    report(target, "nan-rows", dropped - removed, " rows without strain or stress dropped");
    report(target, "extensometer-removed", removed,
           " rows at the end have stress but no strain; Rm is taken from them too");
  }
  Curve& curve = target.corrected;
  bool any_twin = false;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    any_twin = any_twin ||
               (curve.strain[i] == curve.strain[i - 1] && curve.stress[i] == curve.stress[i - 1]);
  }
  if (any_twin) {
    double strain = std::numeric_limits<double>::quiet_NaN();
    double stress = strain;
    const std::size_t dropped = filter(curve, [&](std::size_t i) {
      if (curve.strain[i] == strain && curve.stress[i] == stress) return false;
      strain = curve.strain[i];
      stress = curve.stress[i];
      return true;
    });
    report(target, "duplicates", dropped, " samples equal to the one before dropped");
  }
  return facts;
}

Loading find_loading(const Curve& curve) {
  double largest = 0.0;
  for (const double stress : curve.stress) largest = std::max(largest, std::abs(stress));
  double peak = 0.0;  // of |stress| since the last turn
  std::size_t at = 0;
  bool unloaded = false;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double magnitude = std::abs(curve.stress[i]);
    if (magnitude >= peak && !unloaded) {
      peak = magnitude;
      at = i;
    }
    if (peak < 0.5 * largest) continue;  // settling cycles
    const double sign = curve.stress[at] < 0.0 ? -1.0 : 1.0;
    if (sign * curve.stress[i] < 0.5 * peak && sign * (curve.strain[i] - curve.strain[at]) < 0.0) {
      unloaded = true;
    }
    if (unloaded && magnitude > 0.5 * peak) return Loading::Cyclic;
  }
  return Loading::Monotonic;
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
  report(target, "foot-reversals", least,
         " samples at the foot dropped, where the strain ran backwards under a rising load");
}

void drop_strain_reversals(Target& target, double tolerance) {
  Curve& curve = target.corrected;
  double reached = -std::numeric_limits<double>::infinity();
  const std::size_t dropped = filter(curve, [&](std::size_t i) {
    if (curve.strain[i] < reached - tolerance) return false;
    reached = std::max(reached, curve.strain[i]);
    return true;
  });
  report(target, "strain-reversals", dropped, " samples dropped where the strain ran backwards");
}

}  // namespace plastica::calibrate
