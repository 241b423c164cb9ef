#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

/// Not installed.
namespace plastica::run_detail {

/// Where shear, which rigid joints leave out, may count: in a beam that is less than ten times as
/// long as deep, or where it makes 5 % of the deflection of the longest stretch between supports.
std::optional<std::string> shear_warning(const Facts& facts);

/// Where joints shear and a rectangular tube's shear coefficient is that of thin walls, which its
/// own are not: less than 0.6 of a side is hollow.
std::optional<std::string> thick_wall_warning(const Facts& facts);

}  // namespace plastica::run_detail
