#pragma once

#include <string>

#include "plastica/report/json_values.hpp"
#include "sweeps/report/plot_chart.hpp"

namespace plastica::sweeps {

/// A chart as a block of a page (plastica/report/web/web_blocks.hpp); not installed.
report::Json web_chart(std::string title, const Chart& chart);

}  // namespace plastica::sweeps
