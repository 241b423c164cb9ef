#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

/// Not installed.
namespace plastica::run_detail {

/// Where shear, which rigid joints leave out, may count: in a beam that is less than ten times as
/// long as deep, or one whose longest stretch between supports it lets bend by 5 % more.
std::optional<std::string> shear_warning(const Facts& facts);

}  // namespace plastica::run_detail
