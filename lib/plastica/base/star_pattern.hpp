#pragma once

#include <string_view>

namespace plastica {

/// Whether a name matches a pattern in which each * stands for any text, also none. The time is at
/// most the product of both lengths.
bool matches_stars(std::string_view pattern, std::string_view name);

}  // namespace plastica
