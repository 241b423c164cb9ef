#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "plastica/base/instruction_set.hpp"
#include "plastica/model/beam.hpp"
#include "plastica/model/drive.hpp"
#include "plastica/model/load.hpp"
#include "plastica/model/material.hpp"
#include "plastica/model/motion.hpp"
#include "plastica/model/point_mass.hpp"
#include "plastica/model/probe.hpp"
#include "plastica/model/rules.hpp"
#include "plastica/model/section.hpp"
#include "plastica/model/support.hpp"

namespace plastica {

/// All that a simulation needs to know about the beam and what is done to it; a plain value.
///
/// A scene has either a `drive` (a coupon: uniform strain) or supports and loads.
struct Scene {
  std::string name;
  Material material;
  Section section;
  Beam beam;
  std::vector<Region> regions{};
  Drive drive;
  std::vector<Support> supports{};
  std::vector<Load> loads{};
  std::vector<PointMass> masses{};  ///< what moves and weighs besides the beam
  std::array<double, 3> gravity{};  ///< acceleration in world axes [m/s^2]
  History gravity_history = History::ramp();
  std::vector<InitialMotion> initial_motions{};  ///< dynamics
  std::vector<Cut> cuts{};                       ///< dynamics
  std::vector<Probe> probes{{"stress", ProbeQuantity::Stress}};
  Formulas formulas = Formulas::Mechanics;
  YieldModel yield_model = YieldModel::Interaction;  ///< of a chain; a coupon has one component
  YieldCap yield_cap = YieldCap::FirstYield;
  EndRule end_rule = EndRule::Auto;
  BreakMeasure break_measure = BreakMeasure::Net;
  BreakPolicy on_break = BreakPolicy::CutAll;
  /// Limits of the permanent strain of bending about x, about y and of torsion [1], > 0; empty:
  /// those of the material.
  std::optional<double> break_limit_x{};
  std::optional<double> break_limit_y{};
  std::optional<double> break_limit_z{};
  /// L_p [m], >= 0; empty: the depth h; 0: the strain of a joint is that over its own length (the
  /// report).
  std::optional<double> hinge_length{};

  bool is_coupon() const { return !drive.strain.empty(); }
};

/// How a scene is solved.
struct SolverOptions {
  Level level = Level::Auto;
  Analysis analysis = Analysis::Statics;
  JointTranslation translation = JointTranslation::Rigid;
  /// Float: of chains of ideal plasticity whose joints are rigid in translation.
  Precision precision = Precision::Double;
  /// Whose kernels step articulated schemes. Each level has bits of its own.
  InstructionSet isa = InstructionSet::Auto;
  int fibres = 40;        ///< of a fibre section, along its depth, >= 2
  double duration = 0.0;  ///< end of the path or motion [s], >= 0; 0: where the last history ends
  int steps = 20;         ///< recorded samples, evenly spaced in time, >= 1
  /// Samples of which the whole shape is kept, evenly spaced, the last one among them; 0: all.
  int frames = 0;
  Scheme scheme = Scheme::GeneralizedAlpha;  ///< dynamics, like all below up to `control`
  double time_step = 1e-3;                   ///< [s], > 0; adaptive: the largest one
  /// Adaptive steps: largest error of a segment's place in one step, or of its twist times the
  /// beam's length, over that length [1], >= 0; 0: fixed steps.
  double step_error = 0.0;
  /// Generalized-alpha: how much of the highest frequencies is left after a step [1], 0 … 1.
  double rho_infinity = 0.8;
  RotaryInertia rotary_inertia = RotaryInertia::On;
  Damping damping = Damping::None;
  double damping_time = 0.0;  ///< [s], >= 0
  PathControl control = PathControl::Auto;
  /// Displacement and arc-length control: the point that is watched. Empty: that of the first load;
  /// where it hardly moves, and the path is not controlled by it, the segment end that moves most.
  std::optional<Place> control_at{};
  /// Displacement control: where the control point is taken, in `steps` even parts [m]; of a
  /// twisted beam, z is its angle [rad].
  std::array<double, 3> control_motion{};
  /// Statics: load factors at which the beam buckles, and natural frequencies, that are looked for
  /// about the loaded state, >= 0 (`Response::buckling`, `Response::vibration`).
  int buckling = 0;
  int frequencies = 0;
  int max_iterations = 25;  ///< Newton iterations of a step before it is cut back, >= 1
  /// A step has converged when no joint is out of balance by more than this times the largest
  /// moment of the step, and no support is off by more than this times the length [1], > 0; in
  /// dynamics at least 1e-11 is taken, since forces are differences of positions there; with float
  /// at least 2e-5 everywhere, after six iterations 5e-4 (170 and 4200 units of its rounding).
  double tolerance = 1e-10;
  /// A step may turn no joint by more (statics: no segment by five times) [rad], > 0; or is cut.
  double largest_rotation = 0.2;
  /// Steps are cut back to no less than this part of a recorded step, in dynamics of `time_step`
  /// [1], > 0.
  double smallest_step = 1e-6;
};

/// @throws InputError naming the first field that is out of range or does not fit the others
void check_scene(const Scene& scene, const SolverOptions& options);

}  // namespace plastica
