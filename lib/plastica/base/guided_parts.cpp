#include "plastica/base/guided_parts.hpp"

#include <algorithm>

namespace plastica {

GuidedParts::GuidedParts(std::size_t count, std::size_t workers) : begins_{0} {
  while (begins_.back() < count) {
    const std::size_t left = count - begins_.back();
    const std::size_t part = std::max<std::size_t>(1, left / (2 * workers));
    for (std::size_t worker = 0; worker < workers && begins_.back() < count; ++worker) {
      begins_.push_back(std::min(count, begins_.back() + part));
    }
  }
}

}  // namespace plastica
