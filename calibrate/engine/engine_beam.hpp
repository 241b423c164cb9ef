#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/model/scene.hpp"

namespace plastica::calibrate {

/// What a joint does about one of its axes.
enum class JointHold {
  Free,    ///< nothing
  Sprung,  ///< a torsional spring that yields and breaks
  Rigid,   ///< a weld
};

/// A number of a joint for bending about x, bending about y and twist.
using OfJointAxes = std::array<double, 3>;
/// The unit vectors x, y, z of a frame, in world axes.
using EngineAxes = std::array<std::array<double, 3>, 3>;

/// A moment or an angle that a joint never reaches.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Section and material of a region of the beam: what the scene has at its top, then its regions.
struct EngineRegion {
  Material material;
  Section section;
  SectionProperties properties;
  OfJointAxes stiffness_factor{1.0, 1.0, 1.0};  ///< on E I_x/l, E I_y/l, G J/l [1]
  OfJointAxes cap_factor{1.0, 1.0, 1.0};        ///< on the moments of first yield [1]
};

/// A rigid segment.
struct EngineSegment {
  double length = 0.0;              ///< along the beam's axis [m]
  double mass = 0.0;                ///< with the point masses that it carries [kg]
  std::array<double, 3> inertia{};  ///< about its center, in its axes; with its section's [kg m^2]
  std::array<double, 3> start{};    ///< world axes [m]
  std::array<double, 3> end{};
  double balance = 0.5;  ///< the center of mass on the way from `start` to `end`, 0 … 1 [1]
  EngineAxes axes{};
  std::size_t region = 0;

  std::array<double, 3> center() const { return point(balance); }  ///< of mass
  /// The point at a fraction of the way from `start` to `end`.
  std::array<double, 3> point(double fraction) const;
};

/// A joint between two segments, or between a segment and the ground: the beam's start, and each
/// rigid support off the start.
struct EngineJoint {
  std::string name;                   ///< "joint_0" … by segment ends; "support_2" off the start
  std::optional<std::size_t> parent;  ///< the segment before it; empty: the ground
  std::size_t child = 0;              ///< the segment behind it, or that a support holds
  bool off_start = false;             ///< a support's
  /// A joint to the ground of a held end, which stands for half of its segment.
  bool half_joint = false;
  double at = 0.0;                ///< along the beam's axis [m]
  std::array<double, 3> point{};  ///< world axes [m]
  EngineAxes axes{};
  std::array<bool, 3> holds{};          ///< translations along the scene's x, y, z
  std::array<JointHold, 3> rotation{};  ///< about its own axes
  double length = 0.0;                  ///< tributary length l [m]; 0 where nothing is sprung
  OfJointAxes stiffness{};              ///< [N m/rad]; 0 where it is not sprung
  OfJointAxes hardened_stiffness{};     ///< d moment/d angle behind first yield [N m/rad]; 0: ideal
  OfJointAxes yield_moment{kNever, kNever, kNever};  ///< [N m]
  /// Permanent angle at which it breaks if it turns alone and about one axis alone [rad].
  OfJointAxes break_angle{kNever, kNever, kNever};
  std::size_t region = 0;  ///< whose law it has
};

/// What the segments of a beam touch.
enum class EngineContacts {
  None,
  Others,  ///< everything but each other
  All,     ///< each other, too; not their neighbours
};

/// A beam as an engine of rigid bodies takes it; SI.
struct EngineBeam {
  std::string name;
  std::vector<EngineRegion> regions;
  std::vector<EngineSegment> segments;  ///< (N)
  /// The start's, unless nothing holds it; the N-1 between segments; those of supports.
  std::vector<EngineJoint> joints;
  /// The scene's x, y and z in world axes: others than these where the beam was turned.
  EngineAxes scene_axes{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  std::array<double, 3> gravity{};                ///< world axes [m/s^2]
  double time_step = 1e-3;                        ///< [s]
  std::string_view time_step_of = "the scene's";  ///< who says so
  /// What times its stiffness is a joint's damping [s]; empty: the scene's joints have none.
  std::optional<double> damping_time{};
  EngineContacts contacts = EngineContacts::None;
  Formulas formulas = Formulas::Mechanics;
  YieldModel yield_model = YieldModel::PerAxis;
  YieldCap yield_cap = YieldCap::FirstYield;
  /// L_p of bending about x and y and of torsion (`chain::hinge_lengths`) [m].
  std::array<double, 3> hinge_lengths{};
  bool breaks = false;          ///< whether anything has a limit
  bool carries_masses = false;  ///< whether the scene has point masses
  /// Over which length a the permanent turn of a joint alone counts: "L_p", "l", or which when.
  std::string break_length;
  /// Where the numbers come from, and what of the scene they do not hold: a sentence each.
  std::vector<std::string> notes;
};

/// The numbers of a scene's beam, read off the chain that the solver itself would run in space,
/// whatever the scene's level: layout, joint laws, inertias and break watch are the solver's.
/// Segments always have the rotary inertia of their sections. Loads, springs, pillars and motions
/// are not the beam's, and are not looked at; the notes name the supports that are left out.
/// @param scene    a chain with its final material; it needs no load
/// @param options  of which the time step is taken, and notes are made
/// @throws InputError as `prepare`; if the scene is a coupon; if the inertia of a point mass has
/// principal axes across those of its segment; if a support holds rotation and some
///         translations where the axis is not along z, which one frame of a joint cannot say
EngineBeam engine_beam(const Scene& scene, const SolverOptions& options);

}  // namespace plastica::calibrate
