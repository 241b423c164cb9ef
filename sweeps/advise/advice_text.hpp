#pragma once

#include <string>

#include "sweeps/advise/advice.hpp"

namespace plastica::sweeps {

/// The advice for people: the setting, what each axis adds to its error, what it costs, the next
/// cheaper one that does not do, and the setting of the scene's file.
/// @param name  of the scene's file
std::string advice_text(const Advice& advice, const AdviceOptions& options,
                        const std::string& name);

/// "beam.segments = 16, solver.time_step = 0.001 s"
std::string setting_text(const std::vector<FinenessAxis>& axes, const Setting& setting);

}  // namespace plastica::sweeps
