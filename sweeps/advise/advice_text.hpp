#pragma once

#include <string>

#include "sweeps/advise/advice.hpp"

namespace plastica::sweeps {

/// The advice for people: the setting, what each axis adds to its error, the words with the price
/// of others, what it costs, the next cheaper one that does not do, and the scene's file.
/// @param name  of the scene's file
std::string advice_text(const Advice& advice, const AdviceOptions& options,
                        const std::string& name);

/// "1.25 %"; "unknown" of what is not finite.
std::string error_percent(double fraction);

/// "beam.segments = 16, solver.time_step = 0.001 s"
std::string setting_text(const std::vector<FinenessAxis>& axes, const Setting& setting);
/// The same, with the words that are others than the advised ones.
std::string setting_text(const Advice& advice, const TriedSetting& one);

}  // namespace plastica::sweeps
