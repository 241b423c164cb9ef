#pragma once

#include <span>

#include "plastica/report/json_values.hpp"
#include "sweeps/stability/scene_scan.hpp"

/// Pictures of the scan of a scene as blocks of a page (plastica/report/web/web_blocks.hpp); not
/// installed.
namespace plastica::sweeps::stability {

/// The deviation of each point over the factor on a field, a panel for each field that changes
/// anything; null where none does. Symbols and colours say the verdicts.
report::Json deviation_figure(const SceneScan& scan, const SceneScanOptions& options);

/// The points of two fields that were varied together, and the scene's own.
/// @param rows  of `scan_pair`, not empty
report::Json pair_figure(std::span<const StabilityRow> rows, const ScannedField& first,
                         const ScannedField& second);

}  // namespace plastica::sweeps::stability
