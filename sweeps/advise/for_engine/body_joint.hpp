#pragma once

#include <array>

#include "plastica/base/matrix.hpp"

/// A mate and a bushing between two free bodies, as Chrono takes them; not installed.
///
/// Source: Project Chrono 9, ChLinkMate.cpp (ChLinkMateGeneric: constraints and their Jacobian),
/// ChLoadsBody.cpp (ChLoadBodyBodyBushingMate: the moment), ChLoad.cpp (its slopes).
namespace plastica::sweeps {

/// A rigid body: of its center of mass.
struct BodyState {
  Vec<double, 3> position{};                        ///< world axes [m]
  Mat<double, 3, 3> frame = identity<double, 3>();  ///< columns: its axes in world axes
  Vec<double, 3> velocity{};                        ///< world axes [m/s]
  Vec<double, 3> spin{};                            ///< its own axes [rad/s]
};

/// What holds a body on the one before it. The frames of the joint on both are one undeformed.
struct BodyJoint {
  Mat<double, 3, 3> axes_here = identity<double, 3>();    ///< of the joint, in the body's axes
  Mat<double, 3, 3> axes_before = identity<double, 3>();  ///< in those of the body before
  Vec<double, 3> point_here{};              ///< from the body's center, in its axes [m]
  Vec<double, 3> point_before{};            ///< from the center of the body before, in its axes [m]
  std::array<bool, 3> holds_translation{};  ///< along the joint's axes on the body before
  std::array<bool, 3> holds_rotation{};     ///< about them
  Vec<double, 3> stiffness{};               ///< about them [N m/rad]
  Vec<double, 3> damping{};                 ///< about them [N m s/rad]
};

/// Constraints C of two bodies: by velocity of the center in world axes, then spin in the body's
/// own axes.
struct MateTerms {
  std::size_t rows = 0;
  Mat<double, 6, 6> here{}, before{};  ///< dC/dt by the velocities of each (rows x 6)
  Vec<double, 6> gap{};                ///< C: distances [m], halves of angles [rad] (rows)
};

/// With A and B the joint's frames on the body and on the one before, p_A and p_B their places:
/// B^T (p_A - p_B), and the vector part of the quaternion of B^T A.
MateTerms mate_terms(const BodyJoint& joint, const BodyState& here, const BodyState& before);

/// Moments of a bushing, each in the axes of the body that it acts on, and their slopes with the
/// sign turned: K by rotation increments in each body's own axes, D by its spin.
struct BushingTerms {
  Vec<double, 3> moment_here{}, moment_before{};  ///< [N m]
  Mat<double, 3, 3> stiffness_here_here{}, stiffness_here_before{};
  Mat<double, 3, 3> stiffness_before_here{}, stiffness_before_before{};
  Mat<double, 3, 3> damping_here_here{}, damping_here_before{};
  Mat<double, 3, 3> damping_before_here{}, damping_before_before{};
};

/// Along the axes of B: k times the rotation vector of B^T A and d times the relative spin, on the
/// body before; the opposite on the body. Chrono finds the slopes from differences, which leaves
/// them right to some 1e-8; these are exact.
BushingTerms bushing_terms(const BodyJoint& joint, const BodyState& here, const BodyState& before);

}  // namespace plastica::sweeps
