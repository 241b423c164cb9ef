#include "sweeps/run/first_break.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::sweeps {

std::optional<FirstBreak> first_break(const ChainHistory& chain) {
  for (const ChainBreak& event : chain.events) {
    for (const BrokenJoint& joint : event.joints) {
      if (joint.cause == BreakCause::Cut) continue;
      const double place = static_cast<double>(joint.joint) / static_cast<double>(chain.joints - 1);
      return FirstBreak{event.time, event.factor, joint.joint, place};
    }
  }
  return std::nullopt;
}

bool break_alike(std::optional<double> place, std::int64_t segments,
                 std::optional<double> other_place, std::int64_t other_segments) {
  if (place.has_value() != other_place.has_value()) return false;
  if (!place) return true;
  const auto coarser = std::max<std::int64_t>(std::min(segments, other_segments), 1);
  const double room = (1.0 + 1e-9) / static_cast<double>(coarser);
  return std::abs(*place - *other_place) <= room;
}

}  // namespace plastica::sweeps
