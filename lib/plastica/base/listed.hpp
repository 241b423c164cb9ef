#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

/// Not installed.
namespace plastica {

/// "a, b and c"; of more than `most` names these and how many are left: "a, b and 5 more".
inline std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    const bool last = i + 1 == names.size();
    if (i > 0) list += last ? " and " : ", ";
    list += names[i];
  }
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list;
}

}  // namespace plastica
