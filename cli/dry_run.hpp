#pragma once

#include <span>
#include <string>

#include "calibrate/fit/options.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::cli {

/// Says what a fit would do: targets, their state, parameters with start and bounds, level, memory.
void print_dry_run(std::span<const calibrate::Target> targets, const calibrate::FitOptions& options,
                   const std::string& output);

}  // namespace plastica::cli
