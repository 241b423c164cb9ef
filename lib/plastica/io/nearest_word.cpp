#include "plastica/io/nearest_word.hpp"

#include <algorithm>
#include <vector>

namespace plastica::io {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> cost((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cost[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      at(i, j) =
          std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + (same ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return at(a.size(), b.size());
}

std::optional<std::string> nearest_word(std::string_view typed,
                                        std::span<const std::string> words) {
  std::optional<std::string> nearest;
  std::size_t smallest = typed.size() / 3 + 1;
  for (const std::string& word : words) {
    // Each letter more or less counts: what differs more in length need not be compared.
    const std::size_t longer = std::max(typed.size(), word.size());
    if (longer - std::min(typed.size(), word.size()) > smallest) continue;
    const std::size_t distance = edit_distance(typed, word);
    if (distance < smallest || (distance == smallest && !nearest && distance < typed.size())) {
      nearest = word;
      smallest = distance;
    }
  }
  return nearest;
}

}  // namespace plastica::io
