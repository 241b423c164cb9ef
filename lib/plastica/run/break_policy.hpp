#pragma once

#include <utility>

#include "plastica/model/rules.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Marks the joints of a break that a policy cuts. The worst is that whose strain is furthest over
/// its limit; of several within rounding of each other, that of the lowest number.
/// @param event  `cut` says which joints are hinges, as `BreakWatch::broken` has it
inline void mark_cuts(BreakPolicy policy, ChainBreak& event) {
  if (policy == BreakPolicy::CutAll) return;
  constexpr double kTie = 1e-9;
  BrokenJoint* worst = nullptr;
  const auto use = [](const BrokenJoint& joint) { return joint.strain / joint.limit; };
  for (BrokenJoint& joint : event.joints) {
    const bool is_hinge = std::exchange(joint.cut, false);
    const bool is_worse = worst == nullptr || use(joint) > use(*worst) * (1.0 + kTie);
    if (is_hinge && is_worse) worst = &joint;
  }
  if (policy == BreakPolicy::CutWorst && worst != nullptr) worst->cut = true;
}

}  // namespace plastica
