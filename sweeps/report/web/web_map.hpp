#pragma once

#include <string>

#include "plastica/report/json_values.hpp"
#include "sweeps/report/case_map.hpp"

namespace plastica::sweeps {

/// A map as a block of a page (plastica/report/web/web_blocks.hpp): shaded cells; not installed.
/// @param opens  whether the page has a detail of each case, which its cell opens
report::Json web_map(std::string title, const CaseMap& map, const SweepRecord& record, bool opens);

}  // namespace plastica::sweeps
