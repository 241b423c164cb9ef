#pragma once

#include <cstddef>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"
#include "plastica/chain/layout.hpp"
#include "plastica/model/scene.hpp"
#include "sweeps/advise/for_engine/engine_chain.hpp"

/// What acts on the beam in an engine, and where the scene looks at it; not installed.
namespace plastica::sweeps {

/// The loads of a scene on the segments of its exported beam, as a program sets them: at the place
/// of the scene, at a joint on the segment before it; spread ones at the middle of what each
/// segment has of them.
class EngineLoads {
 public:
  EngineLoads(const Scene& scene, const calibrate::EngineBeam& beam);

  /// World axes [m/s^2].
  Vec<double, 3> gravity(double time) const;
  /// How far the ground at the start has turned, as a rotation vector [rad].
  Vec<double, 3> ground_rotation(double time) const;
  /// Of the present pose. @param wrenches  (N)
  void gather(const EngineChain& chain, double time, std::vector<SegmentWrench>& wrenches) const;
  /// What a probe records of the present pose: displacement, rotation, velocity or spin.
  double observe(const EngineChain& chain, const Probe& probe) const;

 private:
  /// A load of the scene, or what one segment has of it.
  struct PointLoad {
    std::size_t load = 0;  ///< its number in the scene
    chain::SegmentPoint point{};
    double weight = 1.0;  ///< of a spread one the length [m]
  };

  /// The segments whose middles a place lies between, as the beam's slope is: to second order.
  struct BetweenSegments {
    std::size_t before = 0;
    std::size_t beyond = 0;  ///< the same before the first middle, and beyond the last
    double part = 0.0;       ///< of the way from one to the other
  };

  chain::SegmentPoint point_at(const Place& place) const;
  BetweenSegments between(const Place& place) const;

  Scene scene_;  ///< with the segments of the beam
  chain::Layout layout_;
  std::vector<PointLoad> loads_;
};

}  // namespace plastica::sweeps
