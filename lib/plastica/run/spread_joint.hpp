#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/chain/layout.hpp"

namespace plastica {

/// A point of the beam that lies within the length over which a joint is spread, and what of its
/// angle lies before the point. The slope of a chain changes at its joints alone; a joint stands
/// for a curvature that is spread evenly over its length, as the beam's is to second order.
struct SpreadJoint {
  std::size_t node = 0;          ///< of the joint; 0: the point is on its segment alone
  std::array<double, 3> part{};  ///< of the angle about x, y, z of the joint, 0 … 1
  /// Of a moment that acts on the node, the angle that is added before the point [rad/(N m)].
  std::array<double, 3> added{};
};

/// With the angle t of a joint and the moment m on its node the part before the node turns by
/// a (M + m), the part beyond by b M, and t = (a + b)(M + s m) with s = a/(a + b)
/// (`Builder::add_single_load`): s t + s (1 - s)(a + b) m and the rest, each spread evenly over its
/// length. Where the section does not resist, as in a hinge, all of the angle is at the node, and
/// the point turns with its segment.
/// @param joints  of the nodes (N + 1)
/// @param fraction  of the beam's length
/// @param length    of the beam [m]
inline SpreadJoint spread_joint(const chain::Layout& layout,
                                const std::vector<chain::JointModel>& joints, double fraction,
                                double length) {
  const std::size_t segment = chain::segment_point(layout, fraction).segment;
  const bool outer = fraction > 0.5 * (layout.ends[segment] + layout.ends[segment + 1]);
  // Next to an end its inner neighbour: that may have the end's half, too (`Layout::bare_half`).
  if (layout.size() < 2) return {};
  const std::size_t node =
      std::clamp<std::size_t>(outer ? segment + 1 : segment, 1, layout.size() - 1);
  const chain::JointModel& joint = joints[node];
  const double from_node = (fraction - layout.ends[node]) * length;
  SpreadJoint found{node, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!joint.resists[k]) {
      found.part[k] = from_node <= 0.0 ? 0.0 : 1.0;
      continue;
    }
    const bool first = node == 1;
    const bool last = node + 1 == layout.size();
    const double before = layout.length_before[node] + (first ? layout.bare_half[0][k] : 0.0);
    const double beyond = layout.joint_length[node] - layout.length_before[node] +
                          (last ? layout.bare_half[1][k] : 0.0);
    const double fraction_before = joint.fraction_of_moment[k];
    const double added =
        fraction_before * (1.0 - fraction_before) * joint.length[k] / joint.stiffness[k];
    if (from_node <= 0.0) {
      const double part = std::clamp(1.0 + from_node / before, 0.0, 1.0);
      found.part[k] = part * fraction_before;
      found.added[k] = part * added;
    } else {
      const double part = std::clamp(from_node / beyond, 0.0, 1.0);
      found.part[k] = fraction_before + part * (1.0 - fraction_before);
      found.added[k] = (1.0 - part) * added;
    }
  }
  return found;
}

}  // namespace plastica
