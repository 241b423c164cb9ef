#pragma once

#include <stdexcept>
#include <string>

namespace plastica {

/// Closed forms hold within a domain: what lies outside has no number, not a wrong one.
/// @param what  must hold, in the words of the function's arguments
/// @throws std::domain_error if it does not
inline void require_domain(bool holds, const char* what,
                           const char* function = __builtin_FUNCTION()) {
  if (!holds) throw std::domain_error(std::string(function) + ": needs " + what);
}

}  // namespace plastica
