#pragma once

#include <cstddef>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// What the raw rows tell beyond the samples that have both strain and stress.
struct RawFacts {
  double largest_stress = 0.0;        ///< [Pa] over all rows, also those without strain
  bool largest_has_strain = true;     ///< it is among the samples of the repaired curve
  bool extensometer_removed = false;  ///< rows with stress but no strain follow the last strain
};

/// Samples with finite strain and stress, each once: fills target.corrected from target.raw.
/// Repairs "nan-rows", "extensometer-removed", "duplicates" are added to the target.
RawFacts drop_missing(Target& target);

/// Whether a curve is cyclic by the rule of TargetOptions::loading.
Loading find_loading(const Curve& curve);

/// Drops the samples before the least strain of the foot (stress below a fifth of the largest)
/// where the strain ran backwards by more than the tolerance: repair "foot-reversals".
void drop_foot_reversals(Target& target, double tolerance);

/// Drops samples further than the tolerance below the strain reached: "strain-reversals".
void drop_strain_reversals(Target& target, double tolerance);

}  // namespace plastica::calibrate
