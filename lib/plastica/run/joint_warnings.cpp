#include "plastica/run/joint_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "plastica/chain/joint_model.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/support_holds.hpp"
#include "plastica/run/scene_joints.hpp"

namespace plastica::run_detail {
namespace {

using model_detail::figure;

/// A joint that can break, and how many hinge lengths it stands for.
struct LongJoint {
  double length = 0.0;  ///< [m]
  double hinge = 0.0;   ///< L_p [m]
  double times() const { return length / hinge; }
};

/// Of all joints that can break the one that stands for the most hinge lengths; if hinges have no
/// length, any of them.
std::optional<LongJoint> longest_joint(const Facts& facts) {
  std::optional<LongJoint> longest;
  const Scene& scene = facts.scene;
  for (const chain::JointModel& joint :
       scene_joints(*facts.model.chain, material_values(scene.material))) {
    for (std::size_t k = 0; k < joint.resists.size(); ++k) {
      const double limit = k < 2 ? std::min(joint.limit[k], joint.limit[3]) : joint.limit[k];
      if (!joint.resists[k] || !std::isfinite(limit)) continue;
      const LongJoint found{joint.length[k], chain::hinge_lengths(scene, joint)[k]};
      if (!longest || found.times() > longest->times()) longest = found;
    }
  }
  return longest;
}

/// How many equal segments, or with EndRule::Half equal ones but for the ends, have no longer joint
/// than a length.
double segments_for(double longest, const Facts& facts) {
  const chain::Layout& layout = facts.layout;
  bool bare = layout.end_rule == EndRule::ThreeHalves;
  for (const auto& half : layout.bare_half) {
    bare = bare || (bends_about_x(facts.level) && half[0] > 0.0) ||
           (bends_about_y(facts.level) && half[1] > 0.0);
  }
  const double least =
      std::ceil((bare ? 1.5 : 1.0) * facts.scene.beam.length / longest * (1.0 - 1e-9));
  return layout.end_rule == EndRule::Half ? least + 1.0 : least;
}

}  // namespace

std::optional<std::string> hinge_warning(const Facts& facts) {
  const Scene& scene = facts.scene;
  if (scene.yield_model == YieldModel::Elastic || facts.level.level == Level::Twist) {
    return std::nullopt;
  }
  const std::optional<LongJoint> longest = longest_joint(facts);
  if (!longest) return std::nullopt;
  if (longest->hinge == 0.0) {
    if (!is_ideal(scene)) return std::nullopt;
    return "without a hinge length a break depends on the segments: an ideal joint takes all of "
           "the rotation, which at break falls as 1/N";
  }
  const double over = longest->times();
  if (over <= 1.0 + 1e-9) return std::nullopt;
  const std::string cost =
      is_ideal(scene)
          ? "where one of them yields alone under an even moment, its strain is up to " +
                figure(over) + " times too large"
          : "where less than such a length yields, its strain is up to " + figure(over) +
                " times too small";
  return "joints that can break stand for " + figure(longest->length) +
         " m, more than the hinge length of " + figure(longest->hinge) + " m: " + cost + "; " +
         figure(segments_for(longest->hinge, facts)) + " equal segments would do";
}

std::optional<std::string> inner_clamp_warning(const Facts& facts) {
  if (facts.layout.end_rule != EndRule::HalfJoint) return std::nullopt;
  for (std::size_t i = 0; i < facts.scene.supports.size(); ++i) {
    const Support& support = facts.scene.supports[i];
    const double at = fraction_of(support.at, facts.layout.ends);
    const HeldFreedoms held = support.held();
    const bool turns = (held[3] && bends_about_x(facts.level)) ||
                       (held[4] && bends_about_y(facts.level)) ||
                       (held[5] && facts.level.level != Level::Planar);
    if (support.to || !turns || at <= 0.0 || at >= 1.0) continue;
    const std::string what =
        model_detail::item_name("support", i) +
        " holds rotations within the beam: what the two half joints beside it "
        "carry is in its reaction alone, not in probes, tables and pictures of "
        "joints";
    return facts.scene.yield_model == YieldModel::Elastic || !longest_joint(facts)
               ? what
               : what + ", and they do not break; a beam for each side, clamped at its end, does";
  }
  return std::nullopt;
}

std::optional<std::string> rigid_stretch_warning(const Facts& facts) {
  const std::vector<double>& ends = facts.layout.ends;
  const std::vector<double>& lengths = facts.layout.segment_length;
  const auto& supports = facts.scene.supports;
  constexpr std::size_t kFew = 8;  // who has so few segments knows
  if (facts.level.level == Level::Twist || lengths.size() < kFew ||
      !facts.scene.beam.segment_fractions.empty()) {
    return std::nullopt;
  }
  const auto support_at = [&](double end) {
    return std::find_if(supports.begin(), supports.end(), [&](const Support& support) {
      return holds_bending(support, bends_about_x(facts.level), bends_about_y(facts.level)) &&
             fraction_of(support.at, ends) == end;
    });
  };
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const auto first = support_at(ends[i]);
    const auto second = support_at(ends[i + 1]);
    if (first == supports.end() || second == supports.end()) continue;
    const auto name = [&](auto support) {
      return model_detail::item_name("support",
                                     static_cast<std::size_t>(support - supports.begin()));
    };
    return "between " + name(first) + " and " + name(second) + " is one segment of " +
           figure(lengths[i]) +
           " m, which does not bend: what these supports carry may be far off; "
           "beam.segment_lengths can divide it";
  }
  return std::nullopt;
}

}  // namespace plastica::run_detail
