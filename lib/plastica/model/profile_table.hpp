#pragma once

#include <span>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/model/section.hpp"

namespace plastica {

/// Hot rolled I-sections with parallel flanges: IPE 80 to 600, HEA 100 to 1000 and HEB 100 to 1000,
/// nominal dimensions of EN 10365 (before: Euronorm 19 and 53). Their `name` is the one to look up.
std::span<const Section> profile_table();

/// Looks a profile up by its name; blanks and case do not matter, and "HE 300 A" is "HEA 300".
/// @param where, field  where the name was read; they go into the message
/// @throws InputError that says which there are
const Section& named_profile(std::string_view name, const SourceLocation& where = {},
                             std::string_view field = "section.profile");

}  // namespace plastica
