#pragma once

#include <span>
#include <string_view>

#include "plastica/report/plot_script.hpp"
#include "sweeps/stability/stability.hpp"

namespace plastica::sweeps::stability {

/// The map of a study: a panel for each axis, a row for each scene that is scanned along it, a
/// point for each value, in the colour of its class. Values are on a logarithmic scale; zero and
/// infinity stand at its ends. Scans along two axes are left out.
report::PlotScript stability_map(std::span<const StabilityRow> rows);

/// The colour of a class in maps: "#0072B2".
std::string_view class_colour(Validity validity);
/// Its symbol, a number of gnuplot's: round, triangle, star, square.
int class_symbol(Validity validity);

}  // namespace plastica::sweeps::stability
