#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "calibrate/engine/engine_beam.hpp"
#include "plastica/base/matrix.hpp"
#include "sweeps/advise/for_engine/advised_engine.hpp"
#include "sweeps/advise/for_engine/engine_chain.hpp"

namespace plastica::sweeps {

/// What an engine does with a beam that is exported for it, by its published rule: a chain of
/// slides and hinges, stepped in the coordinates q of these. MuJoCo's integrator "Euler" is
///
///   (M + A + h D) a = f - K (q - r) - D v - c(q, v),   v' = v + h a,   q' = q + h v',
///
/// h the time step, M the inertia of the segments, A the armature, D the damping and K the
/// stiffness of the joints (diagonal), r where springs are at rest, f what acts on the segments, c
/// what gravity and the present velocity ask for. Damping is implicit, springs are not; what acts
/// is that of the present pose, as set between `mj_step1` and `mj_step2`. Bullet's multibody is
///
///   M a = f - K (q - r) - D v - c(q, v),   v' = v + h a,   q' = q + h v',
///
/// where the torques of springs and dampers are set before `stepSimulation`, as forces are.
///
/// The matrix is that of an articulated body with A + h D added to each joint, and is solved in
/// O(N) (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7), as Bullet does; MuJoCo
/// factorizes it as it is. All is in world axes, about the inner end of each segment.
///
/// Source: MuJoCo documentation, "Computation", sections "Continuous time" and "Numerical
/// integration", version 2.2.2 with `mj_step`; Bullet 3.24, btMultiBody.h and
/// btMultiBodyDynamicsWorld.h.
class HingeChain final : public EngineChain {
 public:
  /// A beam at rest, undeformed.
  /// @param engine  whose rule it is, which outlives this
  /// @param beam   whose joints are all between neighbours, but the first one, to the ground
  /// @param turns  about which of x, y and z of a joint the hinges are that move: of a motion in a
  ///               plane the others stand still
  /// @throws InputError for a beam with supports off the start, or that nothing holds
  HingeChain(const AdvisedEngine& engine, const calibrate::EngineBeam& beam,
             const std::array<bool, 3>& turns);

  std::size_t size() const override { return segments_.size(); }
  const SegmentPose& pose(std::size_t segment) const override { return segments_[segment].pose; }

  std::size_t freedoms() const { return joints_.size(); }
  double coordinate(std::size_t freedom) const { return joints_[freedom].position; }
  double speed(std::size_t freedom) const { return joints_[freedom].speed; }
  /// Puts the chain into another state. @param positions, speeds  (freedoms)
  void set_state(std::span<const double> positions, std::span<const double> speeds);

  /// Where the spring of the first segment's hinge about an axis is at rest (MuJoCo's
  /// `qpos_spring`, Bullet's torque).
  void set_rest(std::size_t axis, double angle) override;
  bool step(const Vec<double, 3>& gravity, std::span<const SegmentWrench> wrenches) override;

 private:
  /// A slide or a hinge at the inner end of a segment. What comes first carries the others.
  struct Joint {
    bool slides = false;
    Vec<double, 3> axis{};  ///< in the axes of its segment
    double stiffness = 0.0;
    double damping = 0.0;
    double added_inertia = 0.0;  ///< A, and h D where damping is implicit
    std::size_t about = 0;       ///< a hinge: the axis of its joint
    double rest = 0.0;           ///< of its spring
    double position = 0.0;
    double speed = 0.0;
    // Of a step:
    Vec<double, 3> world_axis{};
    Vec<double, 3> turning{};                    ///< d(world axis)/dt
    Vec<double, 3> held_moment{}, held_force{};  ///< that unit acceleration of the joint takes
    double inertia = 0.0;
    double drive = 0.0;
  };
  /// A segment, with the articulated inertia of all from it on: by angular and linear acceleration
  /// of its inner end, moment = aa w + al u, force = al^T w + ll u.
  struct Segment {
    Vec<double, 3> offset{};       ///< of its inner end, in the axes of the segment before [m]
    Mat<double, 3, 3> relative{};  ///< its axes, as seen from the segment before, undeformed
    double mass = 0.0;
    Vec<double, 3> center{};          ///< of mass, from the inner end [m]
    Vec<double, 3> inertia{};         ///< about it, in its axes [kg m^2]
    std::size_t first = 0, last = 0;  ///< its joints
    SegmentPose pose{};
    Vec<double, 3> reach{};  ///< from the inner end of the segment before [m]
    Mat<double, 3, 3> aa{}, al{}, ll{};
    Vec<double, 3> moment{}, force{};  ///< that the present motion asks for
  };

  void add_joints(const calibrate::EngineBeam& beam, const calibrate::EngineJoint& joint,
                  const std::array<bool, 3>& turns);
  /// Poses and velocities of all segments from the coordinates.
  void place();
  /// Inertia of each segment, and what it asks for if no joint accelerates.
  void load(const Vec<double, 3>& gravity, std::span<const SegmentWrench> wrenches);
  /// Takes the joints out one by one, from the last on.
  void eliminate();
  bool advance();
  bool is_in_range(double value) const { return std::abs(value) <= engine_->largest; }

  const AdvisedEngine* engine_ = nullptr;
  std::vector<Segment> segments_;
  std::vector<Joint> joints_;
};

}  // namespace plastica::sweeps
