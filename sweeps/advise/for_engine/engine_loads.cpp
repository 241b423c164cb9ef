#include "sweeps/advise/for_engine/engine_loads.hpp"

#include <algorithm>
#include <cmath>

#include "plastica/chain/rotation.hpp"
#include "plastica/model/beam_axis.hpp"

namespace plastica::sweeps {
namespace {

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

}  // namespace

EngineLoads::EngineLoads(const Scene& scene, const calibrate::EngineBeam& beam)
    : scene_(divided_as(scene, beam)), layout_(chain::make_layout(scene_, ends_of(scene_))) {
  for (std::size_t k = 0; k < scene_.loads.size(); ++k) {
    const Load& load = scene_.loads[k];
    if (!load.to) {
      loads_.push_back({k, point_at(load.at), 1.0});
      continue;
    }
    const double from = fraction_of(load.at, layout_.ends);
    const double to = fraction_of(*load.to, layout_.ends);
    for (std::size_t i = 0; i < layout_.size(); ++i) {
      const double begin = std::max(from, layout_.ends[i]);
      const double end = std::min(to, layout_.ends[i + 1]);
      if (end <= begin) continue;
      loads_.push_back({k, chain::segment_point(layout_, 0.5 * (begin + end)),
                        (end - begin) * scene_.beam.length});
    }
  }
}

chain::SegmentPoint EngineLoads::point_at(const Place& place) const {
  return chain::segment_point(layout_, fraction_of(place, layout_.ends));
}

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

void EngineLoads::gather(const EngineChain& chain, double time,
                         std::vector<SegmentWrench>& wrenches) const {
  wrenches.assign(chain.size(), {});
  for (const PointLoad& one : loads_) {
    const Load& load = scene_.loads[one.load];
    const std::size_t i = one.point.segment;
    const double factor = one.weight * load.history.at(time);
    const Mat<double, 3, 3>& frame = chain.pose(i).frame;
    Vec<double, 3> force = factor * Vec<double, 3>{load.force};
    Vec<double, 3> moment = factor * Vec<double, 3>{load.moment};
    if (load.follows) {
      const Mat<double, 3, 3> turn = frame * transpose(layout_.segment_frame[i]);
      force = turn * force;
      moment = turn * moment;
    }
    wrenches[i].force += force;
    wrenches[i].moment += moment + cross(frame * one.point.arm, force);
  }
}

EngineLoads::BetweenSegments EngineLoads::between(const Place& place) const {
  const double fraction = fraction_of(place, layout_.ends);
  const std::size_t segment = point_at(place).segment;
  const double middle = 0.5 * (layout_.ends[segment] + layout_.ends[segment + 1]);
  const std::size_t before = fraction > middle || segment == 0 ? segment : segment - 1;
  const bool at_end = before + 1 == layout_.size() || (segment == 0 && fraction <= middle);
  if (at_end) return {segment, segment, 0.0};
  const double from = 0.5 * (layout_.ends[before] + layout_.ends[before + 1]);
  const double to = 0.5 * (layout_.ends[before + 1] + layout_.ends[before + 2]);
  return {before, before + 1, (fraction - from) / (to - from)};
}

double EngineLoads::observe(const EngineChain& chain, const Probe& probe) const {
  const chain::SegmentPoint point = point_at(probe.at);
  const Mat<double, 3, 3>& undeformed = layout_.segment_frame[point.segment];
  const BetweenSegments around = between(probe.at);
  const auto mean = [&](const Vec<double, 3>& a, const Vec<double, 3>& b) {
    return a + around.part * (b - a);
  };
  const auto turned = [&](std::size_t i) {
    const Mat<double, 3, 3>& frame = layout_.segment_frame[i];
    return frame * chain::rotation_vector(transpose(frame) * chain.pose(i).frame);
  };
  Vec<double, 3> value;
  switch (probe.quantity) {
    case ProbeQuantity::Rotation: value = mean(turned(around.before), turned(around.beyond)); break;
    case ProbeQuantity::Velocity: value = chain.point_velocity(point.segment, point.arm); break;
    case ProbeQuantity::Spin:
      value = mean(chain.pose(around.before).spin, chain.pose(around.beyond).spin);
      break;
    default:
      value = chain.point(point.segment, point.arm) - layout_.node[point.segment] -
              undeformed * point.arm;
  }
  if (probe.component == Component::Size) return std::sqrt(dot(value, value));
  return value[static_cast<std::size_t>(probe.component)];
}

}  // namespace plastica::sweeps
