#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace plastica {

/// A segment of a chain at rest and its inner joint, in T translations and R rotations.
///
/// Dense numbers of any level: what is done with them is compiled once.
struct SegmentAtRest {
  Eigen::MatrixXd arm;           ///< d(from the joint before) / d(spin) [m] (T x R)
  Eigen::MatrixXd joint_axes;    ///< columns: axes of the joint's rotations in world axes (R x R)
  Eigen::MatrixXd joint_shifts;  ///< of its translations; empty unless it is elastic (T x T)
  Eigen::MatrixXd tangent;       ///< of its law: N m, then N/m (all it lets go, squared)
  double mass = 0.0;             ///< [kg]
  Eigen::MatrixXd center;        ///< d(from its inner joint to its center) / d(spin) [m] (T x R)
  Eigen::MatrixXd axes;          ///< columns: its axes in world axes (R x R)
  Eigen::MatrixXd turning;       ///< inertia about its center in its axes [kg m^2] (R x R)
  /// Of springs and joints to the ground, about the inner joint (T + R, squared).
  Eigen::MatrixXd ground;
};

/// A direction in which a support off the start holds a segment.
struct HeldDirection {
  std::size_t segment;
  Eigen::VectorXd wrench;  ///< a unit of force or moment, about the inner joint (T + R)
  bool turning;            ///< of a rotation
};

/// A chain in its undeformed shape.
struct ChainAtRest {
  double length = 0.0;        ///< of the beam [m]
  bool elastic = false;       ///< whether joints let translations go as well
  std::vector<bool> held;     ///< translations of the start that the ground holds (T)
  bool start_shifts = false;  ///< whether joint 0 does so, too
  std::vector<bool> welded;   ///< rotations of the start that joint 0 does not let go (R)
  std::vector<SegmentAtRest> segments;
  std::vector<HeldDirection> directions;
};

/// Mass and stiffness of a chain for small motions from its undeformed shape, of all that its
/// supports let move.
struct SmallMotion {
  Eigen::MatrixXd mass;       ///< (n x n)
  Eigen::MatrixXd stiffness;  ///< (n x n)
  double softest = 0.0;  ///< least omega^2 of a single coordinate that anything resists [1/s^2]
};

SmallMotion small_motion(const ChainAtRest& chain);

/// In how many ways the chain can move.
int freedoms(const ChainAtRest& chain);

/// Its lowest frequencies, rising; 0 where nothing resists [Hz] (count).
/// @param count  1 … the number of its freedoms
std::vector<double> frequencies(const SmallMotion& motion, int count);

}  // namespace plastica
