#pragma once

#include <span>
#include <string>

#include "calibrate/config/read_target.hpp"
#include "calibrate/fit/options.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "calibrate/target/target.hpp"

namespace plastica::cli {

/// Says what a fit would do: targets, their state, parameters with start and bounds, level, memory.
void print_dry_run(std::span<const calibrate::Target> targets, const calibrate::FitOptions& options,
                   const std::string& output);

/// Says what the curves of a fit file have to be like to be those of a material.
void print_plausible(std::span<const calibrate::TargetBlock> blocks);

/// Says how fits through scenes are repeated with half and with twice the segments, for the error
/// that these make, and why a beam cannot be; nothing if all are coupons.
void print_repetitions(std::span<const calibrate::SceneFitCase> fits);

}  // namespace plastica::cli
