#pragma once

#include <cstddef>

namespace plastica {

/// Physical memory of the machine [bytes]; the largest number there is where it cannot be found
/// out.
std::size_t machine_memory();

}  // namespace plastica
