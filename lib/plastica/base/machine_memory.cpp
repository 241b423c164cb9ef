#include "plastica/base/machine_memory.hpp"

#include <unistd.h>

#include <limits>

namespace plastica {

std::size_t machine_memory() {
  // Every run asks, and the system answers slowly.
  static const std::size_t bytes = [] {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long page = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0) return std::numeric_limits<std::size_t>::max();
    return static_cast<std::size_t>(pages) * static_cast<std::size_t>(page);
  }();
  return bytes;
}

}  // namespace plastica
