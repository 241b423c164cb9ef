#pragma once

#include <string>

#include "sweeps/advise/for_engine/engine_advice.hpp"

namespace plastica::sweeps {

/// All of an advice for an engine, for scripts; SI.
/// @param name  of the scene's file
std::string engine_advice_json(const EngineAdvice& advice, const AdviceOptions& options,
                               const std::string& name);

}  // namespace plastica::sweeps
