#pragma once

namespace plastica {

/// Which formulas set up a joint: Wendelius' to the letter, or the right ones (design 2.4).
enum class Formulas { Mechanics, Report };

/// How the stresses of a joint yield together (design 2.2).
enum class YieldModel {
  Elastic,       ///< never yields
  PerAxis,       ///< each component clipped on its own (Wendelius' report)
  Interaction,   ///< one yield surface over bending, torsion and axial force
  Conservative,  ///< the simple surface (|m_x| + |m_y|)^2 + t^2 = 1: never unsafe, first yield only
  Fibre,         ///< the section cut into fibres, each with the uniaxial law
};

/// Whether a joint has one yield surface for all components.
constexpr bool has_one_surface(YieldModel model) {
  return model == YieldModel::Interaction || model == YieldModel::Conservative;
}

/// The largest moment of an ideal joint: at first yield of the extreme fibre (Wendelius' report),
/// or with the whole section yielding.
enum class YieldCap { FirstYield, FullyPlastic };

/// How the ends of a beam that are held against rotation, and its end segments, are joined
/// (design 2.1).
enum class EndRule {
  Auto,         ///< HalfJoint; with Wendelius' formulas, Equal
  HalfJoint,    ///< a joint to the ground with the tributary length of half a segment
  Equal,        ///< the end segment is clamped; all joints have l = (L_a + L_b)/2
  Half,         ///< clamped; end segments are half as long, all of each for its only joint
  ThreeHalves,  ///< clamped; equal segments, all of an end one for its only joint
};

/// What of the permanent strain is held against the break limit: its present size (Wendelius'
/// report), or the sum of all of it, so that bending to and fro wears out.
enum class BreakMeasure { Net, Accumulated };

/// What happens to joints over their limit: all are cut (of a hinge over several the one that bends
/// most), or the worst of them (the first of the worst, in a tie), or the break is only recorded.
/// What is cut carries nothing from then on and keeps the permanent strain that it broke with.
/// Statics end there, dynamics go on in fragments. A `BreakListener` decides in the policy's place.
enum class BreakPolicy { CutAll, CutWorst, RecordOnly };

/// How much of the beam is modelled.
enum class Level {
  Auto,     ///< the least that holds the scene
  Coupon,   ///< a uniform state, one joint stands for all
  Twist,    ///< rotations about the beam's axis
  Planar,   ///< bending in one plane
  Spatial,  ///< bending about both axes and torsion
};

/// What the joints let the segments do besides rotating.
enum class JointTranslation {
  Rigid,    ///< nothing (lock joints, Wendelius' report)
  Elastic,  ///< stretch, which may yield, and shear, which does not
};

/// The numbers that a chain is computed with. Files, checks and what is recorded have double ones.
enum class Precision { Double, Float };

/// How an equilibrium path is followed.
enum class PathControl {
  Auto,          ///< Load; where it finds nothing, arcs tell a turn from a limit load
  Load,          ///< time is given, and so are all loads and motions
  Displacement,  ///< the control point's displacement is given, the time follows
  ArcLength,     ///< a combination of both is given: passes limit points and snaps
};

}  // namespace plastica
