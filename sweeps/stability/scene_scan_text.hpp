#pragma once

#include <span>
#include <string>

#include "plastica/report/plot_script.hpp"
#include "sweeps/stability/scene_scan.hpp"

namespace plastica::sweeps::stability {

/// Why a field is not followed further: "at 4 inaccurate: tip: history is off …".
std::string end_text(const ScanLimit& limit, const SceneScanOptions& options);

/// What the scene as it is came to: "valid: 0.12 % off a finer run (tip: history)".
std::string own_verdict_text(const SceneScan& scan);

/// A table of the fields: value, from where to where a result is valid, and what comes beyond;
/// then the fields on which no result depends.
std::string scene_scan_text(const SceneScan& scan, const SceneScanOptions& options);

/// The points of a grid of two fields, each in the colour of its class, the scene's own values
/// marked. @param rows  as `scan_pair` gives them, not empty
report::PlotScript pair_map(std::span<const StabilityRow> rows, const Setup& setup,
                            const Field& first, const Field& second,
                            const report::Sheet& sheet = {});

}  // namespace plastica::sweeps::stability
