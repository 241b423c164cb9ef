#include "plastica/model/support.hpp"

#include <algorithm>

namespace plastica {

std::span<const std::string_view> freedom_names() {
  static constexpr std::array<std::string_view, 6> kWords{"x", "y", "z", "rx", "ry", "rz"};
  return kWords;
}

bool Support::moves() const {
  const auto is_set = [](double component) { return component != 0.0; };
  return std::any_of(translation.begin(), translation.end(), is_set) ||
         std::any_of(rotation.begin(), rotation.end(), is_set);
}

}  // namespace plastica
