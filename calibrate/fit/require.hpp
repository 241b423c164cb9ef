#pragma once

#include <fmt/format.h>

#include <string_view>

#include "plastica/base/check.hpp"

/// Not installed.
namespace plastica::calibrate {

/// Refuses a number of the options of a fit. @throws InputError unless the rule holds
inline void require(bool holds, std::string_view field, double value, std::string_view rule) {
  if (!holds) throw InputError({}, field, fmt::format("{:g}", value), rule);
}

}  // namespace plastica::calibrate
