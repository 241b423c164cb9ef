#pragma once

#include <cstddef>

#include "plastica/base/instruction_set.hpp"

/// Newton's method at rest for several chains of one shape side by side. Each lane does the same
/// operations as `equilibrate` does for a lone chain, at a time of its own: the same bits.
namespace plastica::solve {

/// Chains that are solved together.
inline constexpr int kPathLanes = 8;

/// The laws that lanes have; chains with others are solved alone.
enum class LaneLaw { Elastic, Ideal, Linear, VoceChaboche, Multilinear };
inline constexpr std::size_t kLaneLaws = 5;

/// The iterations of one level and law. All numbers are in the order of chain/lane_fields.hpp.
class LaneNewton {
 public:
  virtual ~LaneNewton();

  /// Makes room for chains of a shape; nothing is in the lanes then.
  /// @param shape  sizes, indices and flags of a chain and its joints
  virtual void take_shape(const std::size_t* shape) = 0;
  /// @param numbers  of a chain and its joints
  virtual void take_chain(int lane, const double* numbers) = 0;
  /// @param start  unknowns, scales of imbalance, 0, factors of the histories, states of the laws
  virtual void take_start(int lane, const double* start) = 0;

  /// Places the chains, asks their laws and factors them.
  /// @param imbalance  relative, of each lane (kPathLanes)
  virtual void evaluate(double* imbalance) = 0;
  /// Counts the unstable modes of the chains that were placed last: see `unstable_modes`.
  /// @param counts  of each lane (kPathLanes)
  virtual void count_unstable_modes(double* counts) = 0;
  /// Takes the step of Newton's method that follows, in all lanes.
  virtual void step() = 0;

  /// @param found  unknowns and scales of imbalance
  virtual void read(int lane, double* found) = 0;
  /// @param places  of the segments, where the last `evaluate` has placed them
  virtual void read_places(int lane, double* places) = 0;
  /// @param trial  of the laws there: energies, forces, work and states
  virtual void read_trial(int lane, double* trial) = 0;
};

/// Makes the iterations of a level and law, to be deleted.
struct LaneNewtonTable {
  using Make = LaneNewton* (*)();
  Make planar[kLaneLaws];
  Make spatial[kLaneLaws];
};

extern const LaneNewtonTable kBaselineNewton;
extern const LaneNewtonTable kAvx2Newton;
extern const LaneNewtonTable kAvx512Newton;

/// @param level  not Auto; one that this build has
const LaneNewtonTable& lane_newton(InstructionSet level);

}  // namespace plastica::solve
