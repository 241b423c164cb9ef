#pragma once

#include <string_view>

namespace plastica {

/// Version of the library, "MAJOR.MINOR.PATCH".
std::string_view version();

}  // namespace plastica
