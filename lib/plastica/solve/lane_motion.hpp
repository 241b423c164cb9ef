#pragma once

#include <cstddef>

#include "plastica/model/history.hpp"
#include "plastica/solve/lane_newton.hpp"
#include "plastica/solve/motion_options.hpp"

/// Motions of several chains of one shape that take the same steps, side by side. Each lane does
/// the same operations as a lone chain's `MotionStep`: the same bits, as long as none of its steps
/// is to be cut.
namespace plastica::solve {

/// The steps of one level and law. All numbers are in the order of chain/lane_fields.hpp; what is
/// said of each lane is an array (kPathLanes), in which 1 is yes and 0 is no.
class LaneMotion {
 public:
  virtual ~LaneMotion();

  /// Makes room for chains of a shape, without velocities and states.
  /// @param shape  sizes, indices and flags of a chain and its joints
  virtual void take_shape(const std::size_t* shape) = 0;
  /// @param numbers  of a chain, its joints and its inertias
  virtual void take_chain(int lane, const double* numbers) = 0;
  /// @param velocities  of the segments at time 0, which joints and supports need not allow
  virtual void take_velocities(int lane, const double* velocities) = 0;

  /// Begins at time 0, when all lanes have a chain.
  /// @param options    outlive the motion, like the histories
  /// @param histories  of the chain, which all lanes share
  /// @param free       whether nothing holds the start
  /// @param holds      whether no support holds what others hold already
  virtual void start(const MotionOptions& options, const History* const* histories, bool free,
                     double* holds) = 0;
  /// Tries a step.
  /// @param rides   of which lanes it is asked
  /// @param solved  whether it has succeeded
  /// @param solves  iterations that it took
  /// @param flows   whether any joint flows in it
  virtual void attempt(double h, const double* rides, double* solved, double* solves,
                       double* flows) = 0;
  /// Takes it. @return whether velocities have jumped at its end
  virtual bool accept() = 0;

  /// @param found  of the joints: angles, moments, energies, works
  virtual void read_joints(int lane, double* found) = 0;
  /// After a step was taken. @param axial  axial forces of the joints [N]
  virtual void read_axial(int lane, double* axial) = 0;
  /// @param found  the other unknowns, the pose of a free start; what joints transmit and do,
  ///               velocities, energies, error of momentum
  virtual void read_motion(int lane, double* found) = 0;
};

/// Makes the steps of a level and law, to be deleted.
struct LaneMotionTable {
  using Make = LaneMotion* (*)();
  Make planar[kLaneLaws];
  Make spatial[kLaneLaws];
};

extern const LaneMotionTable kBaselineMotion;
extern const LaneMotionTable kAvx2Motion;
extern const LaneMotionTable kAvx512Motion;

/// @param level  not Auto; one that this build has
const LaneMotionTable& lane_motion(InstructionSet level);

}  // namespace plastica::solve
