#pragma once

#include <string>
#include <string_view>

namespace plastica::testing {

/// Whether a text has some words in it.
inline bool has(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

}  // namespace plastica::testing
