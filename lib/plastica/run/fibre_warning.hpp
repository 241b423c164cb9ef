#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

namespace plastica::run_detail {

/// Where few fibres leave the outermost so far from the section's surface that the section yields
/// later than it should.
std::optional<std::string> fibre_warning(const Facts& facts);

}  // namespace plastica::run_detail
