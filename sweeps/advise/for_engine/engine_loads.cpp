#include "sweeps/advise/for_engine/engine_loads.hpp"

#include <cmath>

#include "plastica/chain/rotation.hpp"
#include "plastica/model/beam_axis.hpp"

namespace plastica::sweeps {
namespace {

using Space = chain::Spatial<double>;

/// The scene, divided as the beam is: its own loads would end segments elsewhere.
Scene divided_as(Scene scene, const calibrate::EngineBeam& beam) {
  scene.beam.segments = static_cast<int>(beam.segments.size());
  scene.beam.segment_fractions.clear();
  for (const calibrate::EngineSegment& segment : beam.segments) {
    scene.beam.segment_fractions.push_back(segment.length / scene.beam.length);
  }
  return scene;
}

std::vector<double> ends_of(const Scene& scene) {
  std::vector<double> ends{0.0};
  for (const double part : scene.beam.segment_fractions) ends.push_back(ends.back() + part);
  ends.back() = 1.0;
  return ends;
}

/// Gravity is the engine's own.
chain::Chain<Space> chain_with_loads(Scene scene, const chain::Layout& layout) {
  scene.gravity = {};
  return chain::build_chain<Space>(scene, layout, {}).chain;
}

}  // namespace

EngineLoads::EngineLoads(const Scene& scene, const calibrate::EngineBeam& beam)
    : scene_(divided_as(scene, beam)),
      layout_(chain::make_layout(scene_, ends_of(scene_))),
      chain_(chain_with_loads(scene_, layout_)) {}

Vec<double, 3> EngineLoads::gravity(double time) const {
  return scene_.gravity_history.at(time) * Vec<double, 3>{scene_.gravity};
}

Vec<double, 3> EngineLoads::ground_rotation(double time) const {
  Vec<double, 3> sum;
  for (const Support& support : scene_.supports) {
    sum += support.history.at(time) * Vec<double, 3>{support.rotation};
  }
  return sum;
}

void EngineLoads::gather(const MujocoChain& chain, double time,
                         std::vector<SegmentWrench>& wrenches) const {
  wrenches.assign(chain.size(), {});
  for (const chain::SegmentLoad<Space>& load : chain_.loads) {
    const double factor = chain_.histories[load.history].at(time);
    const Mat<double, 3, 3>& frame = chain.pose(load.segment).frame;
    const Vec<double, 3> force = factor * (load.follows ? frame * load.force : load.force);
    const Vec<double, 3> moment = factor * (load.follows ? frame * load.moment : load.moment);
    SegmentWrench& wrench = wrenches[load.segment];
    wrench.force += force;
    wrench.moment += moment + cross(frame * load.arm, force);
  }
}

double EngineLoads::observe(const MujocoChain& chain, const Probe& probe) const {
  const chain::SegmentPoint point =
      chain::segment_point(layout_, fraction_of(probe.at, layout_.ends));
  const Mat<double, 3, 3>& undeformed = layout_.segment_frame[point.segment];
  Vec<double, 3> value;
  switch (probe.quantity) {
    case ProbeQuantity::Rotation:
      value = undeformed *
              chain::rotation_vector(transpose(undeformed) * chain.pose(point.segment).frame);
      break;
    case ProbeQuantity::Velocity: value = chain.point_velocity(point.segment, point.arm); break;
    case ProbeQuantity::Spin: value = chain.pose(point.segment).spin; break;
    default:
      value = chain.point(point.segment, point.arm) - layout_.node[point.segment] -
              undeformed * point.arm;
  }
  if (probe.component == Component::Size) return std::sqrt(dot(value, value));
  return value[static_cast<std::size_t>(probe.component)];
}

}  // namespace plastica::sweeps
