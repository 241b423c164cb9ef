#include <algorithm>
#include <array>
#include <cstddef>

#include "plastica/base/check.hpp"
#include "plastica/model/beam_axis.hpp"
#include "plastica/model/check_parts.hpp"
#include "plastica/model/check_value.hpp"
#include "plastica/model/free_motion.hpp"

namespace plastica::model_detail {
namespace {

constexpr std::string_view kNeedsDynamics = "needs solver.analysis = \"dynamics\"";

void check_initial_motion(const Scene& scene, std::size_t index, std::span<const double> ends) {
  const InitialMotion& motion = scene.initial_motions[index];
  const auto name = [&](std::string_view key) { return item_name("initial_motion", index, key); };
  check_place(motion.from, scene.beam.segments, name(".from"));
  check_place(motion.to, scene.beam.segments, name(".to"));
  check_place(motion.about, scene.beam.segments, name(".about"));
  const double from = fraction_of(motion.from, ends);
  const double to = fraction_of(motion.to, ends);
  if (from >= to) {
    throw InputError({}, name(".to"), place_text(motion.to),
                     "must lie beyond from = " + place_text(motion.from));
  }
  bool moves = false;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i - 1] + ends[i]);
    moves = moves || (middle >= from && middle <= to);
  }
  if (!moves) {
    throw InputError({}, name(".to"), place_text(motion.to),
                     "leaves no segment's middle between from = " + place_text(motion.from) +
                         " and itself, so nothing would move");
  }
  check_item(motion, initial_motion_fields(), name(""));
}

/// What is held rigidly can move, but not jump from where the undeformed beam is.
void check_start(const Support& support, const std::string& name) {
  const HeldFreedoms held = support.held();
  const double factor = support.history.at(0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    const double motion = i < 3 ? support.translation[i] : support.rotation[i - 3];
    if (!held[i] || motion == 0.0 || factor == 0.0) continue;
    throw InputError({}, name + ".history", number_text(factor),
                     "is the factor at time 0 and must be 0 in dynamics: what a support holds "
                     "cannot jump");
  }
}

/// Whether a joint ties an end of the beam to the ground, on a level.
struct EndJoint {
  bool there = false;
  bool clamped = false;
};

EndJoint end_joint(const Scene& scene, double fraction, const LevelChoice& level,
                   std::span<const double> ends) {
  const auto freedoms = freedoms_of(level);
  EndJoint joint;
  for (const Support& support : scene.supports) {
    if (support.to || fraction_of(support.at, ends) != fraction) continue;
    const HeldFreedoms held = support.held();
    for (std::size_t i = 3; i < 6; ++i) {
      if (!freedoms[i]) continue;
      joint.clamped = joint.clamped || (held[i] && !has_half_joints(scene));
      joint.there = joint.there || (held[i] && has_half_joints(scene)) ||
                    support.rotational_stiffness[i - 3] > 0.0;
    }
  }
  return joint;
}

}  // namespace

void check_statics(const Scene& scene, const SolverOptions& options) {
  if (!scene.initial_motions.empty()) {
    throw InputError({}, item_name("initial_motion", 0), "", kNeedsDynamics);
  }
  if (!scene.cuts.empty()) throw InputError({}, item_name("cut", 0), "", kNeedsDynamics);
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    const double restitution = scene.supports[i].restitution;
    require(restitution == 0.0, {}, item_name("support", i, ".restitution"), restitution,
            kNeedsDynamics);
  }
  if (options.damping != Damping::None) {
    throw InputError({}, "solver.damping",
                     options.damping == Damping::Stiffness ? "stiffness" : "relaxation",
                     kNeedsDynamics);
  }
  require(options.damping_time == 0.0, {}, "solver.damping_time", options.damping_time,
          kNeedsDynamics);
}

void check_dynamics(const Scene& scene, const SolverOptions& options, Ends ends) {
  for (std::size_t i = 0; i < scene.initial_motions.size(); ++i) {
    check_initial_motion(scene, i, ends);
  }
  for (std::size_t i = 0; i < scene.supports.size(); ++i) {
    check_start(scene.supports[i], item_name("support", i));
  }
  const bool damped = options.damping != Damping::None;
  require(!damped || options.damping_time > 0.0, {}, "solver.damping_time", options.damping_time,
          "must be above 0 s with solver.damping");
  require(damped || options.damping_time == 0.0, {}, "solver.damping_time", options.damping_time,
          "is of no use with solver.damping = \"none\"");
  if (options.control != PathControl::Auto && options.control != PathControl::Load) {
    throw InputError({}, "solver.control",
                     options.control == PathControl::Displacement ? "displacement" : "arc_length",
                     "must be auto or load in dynamics, where time goes on by itself");
  }
  if (options.control_at) {
    throw InputError({}, "solver.control_at", place_text(*options.control_at),
                     "is of no use in dynamics");
  }
}

std::vector<int> check_cuts(const Scene& scene, const LevelChoice& level, Ends ends) {
  std::vector<int> joints;
  for (std::size_t i = 0; i < scene.cuts.size(); ++i) {
    const Cut& cut = scene.cuts[i];
    const std::string field = item_name("cut", i, ".at");
    check_place(cut.at, scene.beam.segments, field);
    require_not_negative(cut.time, {}, item_name("cut", i, ".time"));
    const int joint = nearest_segment_end(cut.at, ends);
    const auto same = std::find(joints.begin(), joints.end(), joint);
    if (same != joints.end()) {
      const auto other = static_cast<std::size_t>(same - joints.begin());
      throw InputError({}, field, place_text(cut.at),
                       item_name("cut", other) + " cuts the nearest joint, that at segment end " +
                           std::to_string(joint) + ", too");
    }
    joints.push_back(joint);
    if (joint > 0 && joint < scene.beam.segments) continue;
    const EndJoint end = end_joint(scene, joint == 0 ? 0.0 : 1.0, level, ends);
    if (end.there) continue;
    throw InputError(
        {}, field, place_text(cut.at),
        std::string("is nearest to the beam's ") + (joint == 0 ? "start" : "end") +
            ", where no joint is: " +
            (end.clamped ? "it is clamped (rules.end_rule)" : "no support holds its rotation"));
  }
  return joints;
}

}  // namespace plastica::model_detail
