#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"
#include "plastica/base/matrix.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"
#include "sweeps/advise/for_engine/body_joint.hpp"
#include "sweeps/advise/for_engine/engine_chain.hpp"

namespace plastica::sweeps {

/// What Project Chrono does with a beam that is exported for it, by its published rule: a chain of
/// free bodies that mates hold and bushings spring. Its default timestepper,
/// EULER_IMPLICIT_LINEARIZED, with a direct solver is
///
///   [ M + h D + h^2 K   J^T ] [ v' ]   [ M v + h f    ]
///   [ J                 0   ] [ -l ] = [ -clamp(C/h)  ],   x' = x + h v',
///
/// h the time step, v the velocities of the bodies (of centers in world axes, spins in the body's
/// own), f all that acts at the present state: gravity, loads, gyroscopic moments, bushings; K and
/// D the slopes of the bushings alone, with the sign turned; C what the mates leave, J = dC/dx, l
/// impulses. Positions go on by h v', rotations by exp of h times the new spin in the body's own
/// axes. C/h is no more than 0.6 either way.
///
/// The right-hand side has no h D v, although f has -D v already: so a damper acts twice for short
/// steps. `hinge_numbers` gives bushings half of the joints' damping for this; then it is that of
/// the trapezoidal rule, stable for any step.
///
/// A body and its multipliers are eliminated together, from the tip on: O(N), by Gaussian
/// elimination of at most 12 rows with pivots.
///
/// Not held against Chrono, which is not in Debian: by its sources alone. Source: Project Chrono 9,
/// src/chrono/timestepper/ChTimestepper.cpp (ChTimestepperEulerImplicitLinearized::Advance),
/// physics/ChSystem.cpp (StateSolveCorrection; AdvanceDynamics: the clamp), physics/ChBody.cpp
/// (IntStateIncrement, ComputeGyro, UpdateForces), and those of `BodyJoint`.
class BodyChain final : public EngineChain {
 public:
  /// A beam at rest, undeformed.
  /// @param engine  whose rule it is, which outlives this
  /// @param beam    whose joints are all between neighbours, but the first one, to the ground
  /// @throws InputError for a beam with supports off the start, or that nothing holds
  BodyChain(const AdvisedEngine& engine, const calibrate::EngineBeam& beam);

  std::size_t size() const override { return bodies_.size(); }
  const SegmentPose& pose(std::size_t segment) const override { return bodies_[segment].pose; }
  void set_rest(std::size_t axis, double angle) override;
  bool step(const Vec<double, 3>& gravity, std::span<const SegmentWrench> wrenches) override;

  /// Gives a segment a velocity of its inner end and a spin, in world axes [m/s], [rad/s]. Mates
  /// need not allow it.
  void set_motion(std::size_t segment, const Vec<double, 3>& velocity, const Vec<double, 3>& spin);

 private:
  /// A segment and its joint to the one before, or to the ground.
  struct Body {
    double mass = 0.0;
    Vec<double, 3> inertia{};  ///< about the center, in the body's axes [kg m^2]
    Vec<double, 3> center{};   ///< of mass, from the segment's inner end, in the body's axes [m]
    BodyJoint joint{};
    BodyState state{};
    SegmentPose pose{};
    // Of a step, by velocities as in MateTerms:
    Mat<double, 6, 6> matrix{};     ///< of the body, and what follows it
    Vec<double, 6> drive{};         ///< right-hand side
    Mat<double, 6, 6> by_before{};  ///< of the body before, in its equations
    Mat<double, 6, 6> in_before{};  ///< of it, in the equations of the body before
    MateTerms mate{};
    Mat<double, 12, 7> solved{};  ///< velocities and impulses: by -(velocity before), and beside
  };

  const BodyState& before(std::size_t i) const { return i == 0 ? ground_ : bodies_[i - 1].state; }
  /// What each body has by itself.
  void load(const Vec<double, 3>& gravity, std::span<const SegmentWrench> wrenches);
  void add_joints();
  void eliminate();
  bool advance();
  void place(Body& body) const;
  bool is_in_range(double value) const { return std::abs(value) <= engine_->largest; }

  const AdvisedEngine* engine_ = nullptr;
  std::vector<Body> bodies_;
  BodyState ground_{};
  Vec<double, 3> turned_{};  ///< the ground, about the axes of the first joint [rad]
  Mat<double, 3, 3> first_axes_ = identity<double, 3>();
  Vec<double, 3> first_point_{};
};

}  // namespace plastica::sweeps
