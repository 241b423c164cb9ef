#include "plastica/base/star_pattern.hpp"

#include <cstddef>
#include <optional>

namespace plastica {

bool matches_stars(std::string_view pattern, std::string_view name) {
  std::size_t p = 0;
  std::size_t n = 0;
  // Behind the last star, and where its text ends so far. What stands before that star is matched
  // as early as it can be, which leaves the most to the rest: no earlier star need be tried again.
  std::optional<std::size_t> behind_star;
  std::size_t star_end = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      behind_star = ++p;
      star_end = n;
    } else if (p < pattern.size() && pattern[p] == name[n]) {
      ++p;
      ++n;
    } else if (behind_star) {
      p = *behind_star;
      n = ++star_end;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace plastica
