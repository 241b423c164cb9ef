#pragma once

#include <string_view>

namespace plastica {

/// Version of the library, "MAJOR.MINOR.PATCH".
std::string_view version();

/// Instruction-set level that the kernels of this build use; stored with every result.
std::string_view instruction_set();

}  // namespace plastica
