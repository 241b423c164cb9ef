#pragma once

#include <string_view>

namespace plastica::calibrate {

/// Whether a name matches a pattern in which each * stands for any text, also none. The time is at
/// most the product of both lengths.
bool matches_column(std::string_view pattern, std::string_view name);

}  // namespace plastica::calibrate
