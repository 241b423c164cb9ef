#pragma once

#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/model/field.hpp"
#include "sweeps/stability/verdict.hpp"

namespace plastica::sweeps::stability {

/// What a scan varies, one or two at a time; the values here are a scene's normal ones, unless it
/// has its own. A beam is a square of L/slenderness.
struct Knobs {
  double youngs_modulus = 200e9;  ///< E [Pa]
  double poisson_ratio = 0.3;     ///< [1]
  double yield_stress = 250e6;    ///< sigma_y [Pa]
  double segments = 16.0;         ///< N
  double length = 1.0;            ///< L [m]
  double slenderness = 50.0;      ///< L/h [1]
  double mass_ratio = 1.0;        ///< density of every second segment over that of the others [1]
  /// Size of what acts over what makes a steel of 250 MPa yield, or another size of the scene [1].
  double load = 0.5;
  double time_step = 0.0;        ///< [s]; 0: `steps_in_period` in the lowest period
  double steps_in_period = 100;  ///< [1]
  double steps = 400.0;          ///< of the motion
  double damping = 0.0;          ///< of the first mode over critical [1]
  double spin = 10.0;            ///< [rad/s]
  double reversal = 50.0;        ///< steps after which a load that is reversed turns round [1]
  double scheme = 2.0;           ///< number of `Scheme`
  double path_steps = 20.0;      ///< of a path
  double flexibility = 10.0;     ///< P L^2/(E I) [1]
  double critical = 0.8;         ///< load over the critical one [1]
  double axial = 0.5;            ///< axial force over what the section carries [1]
  double place = 0.5;            ///< where a part of another section begins, over L [1]
};

/// A run and what is known of it.
struct StabilityCase {
  Setup setup;
  Expectation expected;
};

/// One of the scenes that the scans start from.
struct BaseScene {
  std::string_view name;  ///< unique: "planar tip force"
  Level level = Level::Planar;
  Analysis analysis = Analysis::Statics;
  StabilityCase (*make)(const Knobs&) = nullptr;
  Knobs normal{};
  /// Names of the axes that the scene is scanned along, see scan.hpp; pairs of two names are
  /// scanned together.
  std::vector<std::string_view> axes{};
  std::vector<std::pair<std::string_view, std::string_view>> pairs{};
};

/// The scenes of a level, in the order in which they are shown.
std::vector<BaseScene> coupon_scenes();
std::vector<BaseScene> twist_scenes();
std::vector<BaseScene> planar_path_scenes();
std::vector<BaseScene> planar_motion_scenes();
std::vector<BaseScene> spatial_scenes();
std::vector<BaseScene> critical_scenes();

}  // namespace plastica::sweeps::stability
