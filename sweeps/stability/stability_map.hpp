#pragma once

#include <span>

#include "plastica/report/plot_script.hpp"
#include "sweeps/stability/stability.hpp"

namespace plastica::sweeps::stability {

/// The map of a study: a panel for each axis, a row for each scene that is scanned along it, a
/// point for each value, in the colour of its class. Values are on a logarithmic scale; zero and
/// infinity stand at its ends. Scans along two axes are left out.
report::PlotScript stability_map(std::span<const StabilityRow> rows);

}  // namespace plastica::sweeps::stability
