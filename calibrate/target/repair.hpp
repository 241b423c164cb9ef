#pragma once

#include <cstddef>

#include "calibrate/target/options.hpp"
#include "calibrate/target/strain_end.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// What the raw rows tell beyond the samples that have both strain and stress.
struct RawFacts {
  double largest_stress = 0.0;        ///< [Pa] over all rows, also those without strain
  bool largest_has_strain = true;     ///< it is among the samples of the repaired curve
  bool extensometer_removed = false;  ///< rows with stress but no strain follow the last strain
  StrainEnd strain_end;               ///< of the record
};

/// Samples with finite strain and stress, each once: fills target.corrected from target.raw. A
/// strain that stands still to the end while the load goes on is none (`strain_end`).
/// Repairs "nan-rows", "extensometer-removed", "duplicates" are added to the target.
RawFacts drop_missing(Target& target);

/// Says that more than a fifth of the samples were dropped as of no monotonic test, and by which
/// repairs; empty of fewer, and of a cyclic curve.
std::string too_many_dropped(const Target& target);

/// Whether a curve is cyclic by the rule of TargetOptions::loading.
Loading find_loading(const Curve& curve);

/// Drops the samples before the least strain of the foot (stress below a fifth of the largest)
/// where the strain ran backwards by more than the tolerance: repair "foot-reversals".
void drop_foot_reversals(Target& target, double tolerance);

/// Drops unloading and reloading amid a monotonic curve, repair "unloading-loops": samples further
/// than the tolerance below the strain reached, from half of Rm or more, in which the stress falls
/// by a tenth of Rm or more, and comes back to (1 - drop_fraction) of where it was as the strain
/// does.
void drop_unloading_loops(Target& target, const TargetOptions& options);

/// Drops the unloading at the end of a monotonic curve, repair "unloading": from the largest strain
/// and half of Rm or more on, the stress falls by a tenth of Rm or more, over 3 samples or more and
/// none by more than half of the fall, while the strain falls along a line of 0.5 to 1.5 of the
/// modulus, with all samples within 0.15 of the fall from it. An extensometer that snaps back at a
/// break jumps or leaves that line.
/// @return whether there was such an end: the specimen did not break
bool drop_unloading(Target& target, double modulus, const TargetOptions& options);

}  // namespace plastica::calibrate
