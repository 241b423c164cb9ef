#pragma once

#include <string>

#include "sweeps/advise/for_engine/engine_advice.hpp"

namespace plastica::sweeps {

/// What an advice for an engine says, for people.
/// @param name  of the scene's file
std::string engine_advice_text(const EngineAdvice& advice, const AdviceOptions& options,
                               const std::string& name);

}  // namespace plastica::sweeps
