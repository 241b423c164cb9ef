#pragma once

#include <string>

#include "sweeps/advise/advice.hpp"

namespace plastica::sweeps {

/// The advice for scripts: one JSON object in SI units with all that its text has, and every
/// setting that was run (`tried`). What there is not is null, so is every number that is not
/// finite. The order of the keys is fixed.
/// @param name  of the scene's file
std::string advice_json(const Advice& advice, const AdviceOptions& options,
                        const std::string& name);

}  // namespace plastica::sweeps
