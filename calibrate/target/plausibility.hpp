#pragma once

#include <span>
#include <string>
#include <vector>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Why a tension curve is that of no material, with the likely cause, from its characteristics;
/// empty if it may be one, or where Young's modulus is not known. Judged are
/// - Young's modulus, if it was measured, and how far it is from the expected one;
/// - the yield strain: the proof stress (the strength, where there is none) over Young's modulus.
///   That of strong materials is at most some 2 %, and that of soft ones that yield at least some
///   0.5 %: polymers yield by chains that uncoil, metals by dislocations;
/// - the largest strain.
/// The cause is looked for among mistakes of units and areas that would make a usual metal of it
/// (E 40 to 420 GPa, yield strain 0.02 to 1.5 %), or be near the expected modulus.
std::string why_implausible(const Target& target, const TargetOptions& options);

/// Warns of a tension curve that passes, but is as soft as rubber (E below 0.5 GPa), or yields as
/// late as metals do (above `strong_stress`) and is softer than each of them (E below 30 GPa,
/// measured, where none is expected).
void warn_of_softness(Target& target, const TargetOptions& options);

/// What the gate asks, in a line: for people who want to know or change the bounds.
std::string plausible_text(const TargetOptions& options);

/// Refuses a target, or warns of it where the options accept it.
void refuse_implausible(Target& target, std::string reason, const TargetOptions& options);

/// Refuses what is `group_factor` times off its group's median, in Young's modulus or strength,
/// where a group has three specimens or more that are ready.
void check_groups(std::span<Target> targets, const TargetOptions& options);

}  // namespace plastica::calibrate
