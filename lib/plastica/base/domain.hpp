#pragma once

#include <source_location>
#include <stdexcept>
#include <string>

namespace plastica {

/// Closed forms hold within a domain: what lies outside has no number, not a wrong one.
/// @param what  must hold, in the words of the function's arguments
/// @throws std::domain_error if it does not
inline void require_domain(bool holds, const char* what,
                           std::source_location where = std::source_location::current()) {
  if (holds) return;
  throw std::domain_error(std::string(where.function_name()) + ": needs " + what);
}

}  // namespace plastica
