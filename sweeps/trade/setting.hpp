#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sweeps/store/sweep_record.hpp"
#include "sweeps/trade/pareto.hpp"

namespace plastica::sweeps {

/// What a case costs.
enum class CostKind {
  Work,     ///< segment-iterations, which no machine changes
  Seconds,  ///< least CPU time of its runs, where the sweep timed them [s]
};

/// The cases of a sweep as points of a trade, in their order; a case without a usable status or
/// without an error is one that failed.
std::vector<TradePoint> trade_points(const SweepRecord& record, CostKind cost);

/// The same for a recommendation: the error of a point is what can be promised, that of the case
/// and that of its reference. A reference has its own; a case whose error is not that of all axes
/// has none. Points of a group differ in axes that refine by numbers.
std::vector<TradePoint> promised_points(const SweepRecord& record, CostKind cost);

/// The error that `promised_points` promises of a case [1]; none: nothing.
std::optional<double> promised_error(const SweepRecord& record, std::size_t index);

/// Whether a sweep varies the problem, such as lengths, materials or loads.
bool has_problems(const SweepRecord& record);

/// Refuses a sweep that varies the problem, such as lengths, materials or loads: its cases are no
/// settings of one scene to choose from. What refines, and methods, are: see plan/refining.hpp.
/// @throws InputError that names the axis
void check_settings(const SweepRecord& record);

/// What tells a case from the others: "beam.segments = 32, rules.end_rule = equal".
std::string setting_text(const SweepRecord& record, std::size_t index);

/// The scene's file with a case's values filled in and all else as it was written; what [set] fixes
/// included.
/// @param folder  where the tables are that the scene names
/// @param output  the new file
/// @throws InputError if a value cannot be written there, such as a factor on all loads
std::string scene_with_setting(const SweepRecord& record, std::size_t index,
                               const std::string& folder = "", const std::string& output = "scene");

}  // namespace plastica::sweeps
