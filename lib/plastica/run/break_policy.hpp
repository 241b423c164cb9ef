#pragma once

#include <algorithm>

#include "plastica/model/rules.hpp"
#include "plastica/run/response.hpp"

namespace plastica {

/// Marks the joints of a break that a policy cuts. The worst is that whose strain is furthest over
/// its limit; of several within rounding of each other, that of the lowest number.
inline void mark_cuts(BreakPolicy policy, ChainBreak& event) {
  for (BrokenJoint& joint : event.joints) joint.cut = policy == BreakPolicy::CutAll;
  if (policy != BreakPolicy::CutWorst || event.joints.empty()) return;
  constexpr double kTie = 1e-9;
  const auto use = [](const BrokenJoint& joint) { return joint.strain / joint.limit; };
  double most = 0.0;
  for (const BrokenJoint& joint : event.joints) most = std::max(most, use(joint));
  for (BrokenJoint& joint : event.joints) {
    if (use(joint) < most * (1.0 - kTie)) continue;
    joint.cut = true;
    return;
  }
}

}  // namespace plastica
