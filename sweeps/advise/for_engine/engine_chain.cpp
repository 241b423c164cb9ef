#include "sweeps/advise/for_engine/engine_chain.hpp"

#include <algorithm>

#include "plastica/base/check.hpp"
#include "sweeps/advise/for_engine/body_chain.hpp"
#include "sweeps/advise/for_engine/hinge_chain.hpp"

namespace plastica::sweeps {

Vec<double, 3> EngineChain::point(std::size_t segment, const Vec<double, 3>& arm) const {
  const SegmentPose& at = pose(segment);
  return at.position + at.frame * arm;
}

Vec<double, 3> EngineChain::point_velocity(std::size_t segment, const Vec<double, 3>& arm) const {
  const SegmentPose& at = pose(segment);
  return at.velocity + cross(at.spin, at.frame * arm);
}

std::unique_ptr<EngineChain> engine_chain(const AdvisedEngine& engine,
                                          const calibrate::EngineBeam& beam,
                                          const std::array<bool, 3>& turns) {
  if (engine.rule == EngineRule::Hinges) return std::make_unique<HingeChain>(engine, beam, turns);
  return std::make_unique<BodyChain>(engine, beam);
}

const calibrate::EngineJoint& joint_before(const calibrate::EngineBeam& beam, std::size_t segment) {
  const auto joint = std::ranges::find_if(
      beam.joints, [&](const auto& one) { return !one.off_start && one.child == segment; });
  if (joint != beam.joints.end()) return *joint;
  throw InputError({}, "support", "", "is missing: nothing holds the beam at its start");
}

void check_held_at_start(const calibrate::EngineBeam& beam) {
  for (const calibrate::EngineJoint& joint : beam.joints) {
    if (joint.off_start) throw InputError({}, joint.name, "", "is off the beam's start");
  }
}

Mat<double, 3, 3> frame_of(const calibrate::EngineAxes& axes) {
  Mat<double, 3, 3> m;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t k = 0; k < 3; ++k) m(k, axis) = axes[axis][k];
  }
  return m;
}

}  // namespace plastica::sweeps
