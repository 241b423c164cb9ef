#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "calibrate/engine/engine_beam.hpp"
#include "plastica/base/matrix.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"

/// A beam as an engine steps it; not installed.
namespace plastica::sweeps {

/// Force and moment on a segment.
struct SegmentWrench {
  Vec<double, 3> force{};   ///< world axes [N]
  Vec<double, 3> moment{};  ///< about the segment's inner end, world axes [N m]
};

/// Where a segment is and how it moves.
struct SegmentPose {
  Vec<double, 3> position{};                        ///< of its inner end [m]
  Mat<double, 3, 3> frame = identity<double, 3>();  ///< columns: its axes in world axes
  Vec<double, 3> velocity{};                        ///< of its inner end [m/s]
  Vec<double, 3> spin{};                            ///< world axes [rad/s]
};

/// An exported beam with an engine's rule of a step: `HingeChain`, `BodyChain`.
class EngineChain {
 public:
  virtual ~EngineChain() = default;

  virtual std::size_t size() const = 0;
  virtual const SegmentPose& pose(std::size_t segment) const = 0;

  /// Turns the ground of the first segment about an axis of its joint: what a clamp has turned, in
  /// a plane (0 at the beginning) [rad].
  /// @param axis  0 … 2, about which the first joint turns
  virtual void set_rest(std::size_t axis, double angle) = 0;

  /// One step. Allocates nothing.
  /// @param gravity  acceleration in world axes [m/s^2]
  /// @param wrenches  (N)
  /// @return false where the engine gives up: a coordinate, a speed or an acceleration is not
  ///         finite, or beyond its largest
  virtual bool step(const Vec<double, 3>& gravity, std::span<const SegmentWrench> wrenches) = 0;

  double time_step() const { return time_step_; }
  /// Of a point, as seen from the segment's inner end in its axes.
  Vec<double, 3> point(std::size_t segment, const Vec<double, 3>& arm) const;
  Vec<double, 3> point_velocity(std::size_t segment, const Vec<double, 3>& arm) const;

 protected:
  explicit EngineChain(double time_step) : time_step_(time_step) {}
  EngineChain(const EngineChain&) = default;
  EngineChain& operator=(const EngineChain&) = default;

 private:
  double time_step_ = 0.0;
};

/// A beam at rest, undeformed, with the rule of an engine, which outlives it.
/// @param turns  about which of x, y and z of a joint the hinges are that move, where the rule is
///               of hinges: of a motion in a plane the others stand still
/// @throws InputError for a beam with supports off the start, or that nothing holds
std::unique_ptr<EngineChain> engine_chain(const AdvisedEngine& engine,
                                          const calibrate::EngineBeam& beam,
                                          const std::array<bool, 3>& turns);

/// The joint between a segment and what is before it.
/// @throws InputError if nothing holds the segment
const calibrate::EngineJoint& joint_before(const calibrate::EngineBeam& beam, std::size_t segment);

/// @throws InputError if a support of the beam is off its start
void check_held_at_start(const calibrate::EngineBeam& beam);

/// Columns: the axes of a frame.
Mat<double, 3, 3> frame_of(const calibrate::EngineAxes& axes);

}  // namespace plastica::sweeps
