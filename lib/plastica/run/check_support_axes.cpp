#include "plastica/run/check_support_axes.hpp"

#include <cstddef>
#include <string>

#include "plastica/base/check.hpp"
#include "plastica/chain/support_axes.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/shared_moments.hpp"

namespace plastica {

void check_support_axes(const Scene& scene, const chain::Layout& layout) {
  for (std::size_t i = 0; i < scene.loads.size(); ++i) {
    const Load& load = scene.loads[i];
    if (!load.follows || !model_detail::shares_moment(scene, load, layout.ends)) continue;
    throw InputError(
        {}, model_detail::item_name("load", i, ".moment"), "",
        "follows the beam where a rotational spring holds it within: the spring takes a "
        "share of the moment that does not follow; move one of them by a segment");
  }
  // A rigid clamp holds about the world's axes.
  const bool half = layout.end_rule == EndRule::HalfJoint;
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const Support& support = scene.supports[i];
    if (support.to) continue;
    const double fraction = fraction_of(support.at, layout.ends);
    const std::size_t node =
        fraction == 0.0 ? 0 : chain::segment_point(layout, fraction).segment + 1;
    const auto& frame = layout.joint_frame[node];
    const auto refuse = [&](const char* key, const char* what) {
      throw InputError({}, model_detail::item_name("support", i, key), "",
                       std::string("is about axes of the world that lie skew to the beam's own "
                                   "there, about which joints turn: ") +
                           what);
    };
    if ((half || node == 0) && !chain::held_rotations(support, frame)) {
      refuse(".hold", "hold rx, ry and rz, or none");
    }
    if (!chain::rotational_springs(support, frame)) {
      refuse(".rotational_stiffness", "give all three the same, or turn the beam");
    }
  }
}

}  // namespace plastica
