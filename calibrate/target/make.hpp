#pragma once

#include <string>

#include "calibrate/target/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::calibrate {

/// Repairs, corrects and characterises a curve that a program made or read.
///
/// Order: rows without numbers, duplicates, foot reversals, elastic line, trim at break, strain
/// reversals, strain shift, true measure, characteristics, sampling check. A curve that cannot be
/// used comes back as TooCoarse or Rejected with the reason.
/// @param raw  strain [1] and stress [Pa], equally long; NaN where a value is missing
/// @throws InputError for options that contradict themselves
Target make_target(std::string name, Curve raw, const TargetOptions& options = {});

/// The same on a target whose name, file and raw curve are filled in already.
void process_target(Target& target, const TargetOptions& options);

}  // namespace plastica::calibrate
