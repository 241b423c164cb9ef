#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sweeps/stability/base_scene.hpp"
#include "sweeps/stability/scene_parts.hpp"

namespace plastica::sweeps::stability {
namespace {

using namespace parts;

/// A torque at the free end: a half joint and N - 1 whole ones, of which the last has the half
/// segment at the end, too, turn by T l/(G J) each.
StabilityCase torque(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Twist, YieldModel::Elastic);
  const Numbers b(knobs);
  const double T = knobs.load * b.twist_yield;
  push(made, Place::end(), {}, {0.0, 0.0, T});
  // The first inner joint: the last one has the half segment at the end, too.
  const Place inner = knobs.segments >= 2.0 ? Place{0.0, 1} : Place::start();
  const std::size_t turn = probe(made, ProbeQuantity::Angle, inner, Component::Z);
  const std::size_t root = probe(made, ProbeQuantity::Angle, Place::start(), Component::Z);
  if (knobs.segments >= 2.0) {
    made.expected.references.push_back({.what = "rotation of a joint",
                                        .probe = turn,
                                        .value = (b.n == 2.0 ? 1.5 : 1.0) * T * b.L / b.n / b.GJ,
                                        .tolerance = 1e-8});
  }
  made.expected.references.push_back({.what = "rotation of the half joint",
                                      .probe = root,
                                      .value = 0.5 * T * b.L / b.n / b.GJ,
                                      .tolerance = 1e-8});
  return made;
}

StabilityCase yielding(const Knobs& knobs, YieldModel model) {
  StabilityCase made = cantilever(knobs, Level::Twist, model);
  const Numbers b(knobs);
  push(made, Place::end(), {}, {0.0, 0.0, knobs.load * b.twist_yield});
  const double limit = knobs.yield_stress / kNominalYield / knobs.load;
  if (limit < 1.0) made.expected.limit = limit;
  return made;
}
StabilityCase yields(const Knobs& knobs) { return yielding(knobs, YieldModel::Interaction); }
StabilityCase clips(const Knobs& knobs) { return yielding(knobs, YieldModel::PerAxis); }

/// Both ends clamped, a torque in the middle: half of it goes each way.
StabilityCase held_twisted(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Twist, YieldModel::Elastic);
  made.setup.scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Clamp});
  const Numbers b(knobs);
  const double T = knobs.load * b.twist_yield;
  const double middle = std::floor(knobs.segments / 2.0);
  push(made, {0.0, rounded(middle)}, {}, {0.0, 0.0, T});
  const std::size_t start =
      probe(made, ProbeQuantity::ReactionMoment, Place::start(), Component::Z);
  // Half of the torque is on each side of the joint, middle - 1/2 and middle + 1/2 joint lengths
  // from the start.
  made.expected.references.push_back({.what = "torque of the start",
                                      .probe = start,
                                      .value = -T * (b.n - middle) / b.n,
                                      .tolerance = 1e-8});
  return made;
}

/// The end is turned until the shaft breaks.
StabilityCase breaks_twisted(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Twist, YieldModel::Interaction);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  Support turned;
  turned.at = Place::end();
  turned.kind = SupportKind::Clamp;
  const double at_yield = b.twist_yield * b.L / b.GJ * knobs.yield_stress / kNominalYield;
  turned.rotation = {0.0, 0.0, knobs.load * at_yield};
  scene.supports.push_back(turned);
  scene.material.break_shear_strain = 0.01;
  return made;
}

/// The first mode of a free bar, cos((i + 1/2) pi/N) of segment i: omega = 2 sin(pi/(2N))
/// sqrt(k/J).
StabilityCase vibration_twisted(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Twist, YieldModel::Elastic);
  const Numbers b(knobs);
  const int n = rounded(knobs.segments);
  const double part = b.L / b.n;
  const double omega = 2.0 * std::sin(std::numbers::pi / (2.0 * b.n)) *
                       std::sqrt(b.GJ / part / (2.0 * b.rho_I * part));
  in_motion(made, knobs, 2.0 * std::numbers::pi / omega);
  const double amplitude = 0.1 * knobs.load;
  const double speed = amplitude * omega;
  for (int i = 0; i < n; ++i) {
    InitialMotion motion{.from = {0.0, i}, .to = {0.0, i + 1}};
    motion.spin = {0.0, 0.0, speed * std::cos((i + 0.5) * std::numbers::pi / b.n)};
    made.setup.scene.initial_motions.push_back(motion);
  }
  const std::size_t turn = probe(made, ProbeQuantity::Rotation, Place::start(), Component::Z);
  const SolverOptions& solver = made.setup.solver;
  const double phase = omega * solver.time_step;
  const bool damped = knobs.damping > 0.0 || solver.scheme == Scheme::LinearlyImplicitEuler;
  if (!damped && knobs.mass_ratio == 1.0) {
    // Midpoint rules turn a linear vibration by 2 atan(omega h/2) a step, others nearly so.
    const double steps = knobs.steps;
    const double turned = steps * 2.0 * std::atan(0.5 * phase);
    const double end = amplitude * std::cos(std::numbers::pi / (2.0 * b.n));
    const double own = solver.scheme == Scheme::GeneralizedAlpha
                           ? std::min(2.0, steps * phase * phase * phase / 4.0)
                           : 0.0;
    made.expected.references.push_back({.what = "rotation of an end",
                                        .probe = turn,
                                        .value = end * std::sin(turned),
                                        .size = end,
                                        .tolerance = 0.01 + own,
                                        .continuum = end * std::sin(steps * phase)});
  }
  return made;
}

/// A free bar that spins about its own axis.
StabilityCase spins_twisted(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Twist, YieldModel::Elastic);
  const Numbers b(knobs);
  in_motion(made, knobs, twisting_period(b));
  InitialMotion motion;
  motion.spin = {0.0, 0.0, knobs.spin};
  made.setup.scene.initial_motions.push_back(motion);
  const std::size_t spin = probe(made, ProbeQuantity::Spin, Place::end(), Component::Z);
  made.expected.kept.push_back({"spin", spin, knobs.spin, 1e-6});
  return made;
}

/// A torque that is there from the first moment, on an ideal shaft.
StabilityCase struck(const Knobs& knobs, bool breaks) {
  StabilityCase made = cantilever(knobs, Level::Twist, YieldModel::Interaction);
  const Numbers b(knobs);
  in_motion(made, knobs, twisting_period(b));
  push(made, Place::end(), {}, {0.0, 0.0, knobs.load * b.twist_yield}, History::constant());
  if (breaks) made.setup.scene.material.break_shear_strain = 0.001;
  return made;
}
StabilityCase struck_yields(const Knobs& knobs) { return struck(knobs, false); }
StabilityCase struck_breaks(const Knobs& knobs) { return struck(knobs, true); }

}  // namespace

std::vector<BaseScene> twist_scenes() {
  using enum Analysis;
  const std::vector<std::string_view> path{"modulus", "segments", "slenderness",
                                           "load",    "poisson",  "length"};
  const std::vector<std::string_view> yield_path{"modulus", "segments", "slenderness", "load",
                                                 "yield",   "poisson",  "length"};
  const std::vector<std::string_view> motion{"modulus",    "segments", "time step", "slenderness",
                                             "mass ratio", "load",     "poisson",   "damping",
                                             "length",     "scheme"};
  const std::vector<std::string_view> yield_motion{
      "modulus", "segments", "time step", "slenderness", "mass ratio", "load",
      "yield",   "poisson",  "damping",   "length",      "scheme"};
  Knobs wave;
  wave.scheme = 3.0;
  Knobs over;
  over.load = 2.0;
  return {
      {"twist torque",
       Level::Twist,
       Statics,
       torque,
       {},
       path,
       {{"modulus", "segments"}, {"length", "slenderness"}}},
      {"twist held", Level::Twist, Statics, held_twisted, {}, path, {{"modulus", "load"}}},
      {"twist interaction", Level::Twist, Statics, yields, over, yield_path, {{"load", "yield"}}},
      {"twist per axis", Level::Twist, Statics, clips, over, yield_path, {{"load", "yield"}}},
      {"twist break",
       Level::Twist,
       Statics,
       breaks_twisted,
       over,
       yield_path,
       {{"modulus", "load"}}},
      {"twist vibration",
       Level::Twist,
       Dynamics,
       vibration_twisted,
       wave,
       motion,
       {{"modulus", "time step"}, {"time step", "scheme"}}},
      {"twist spin",
       Level::Twist,
       Dynamics,
       spins_twisted,
       {},
       {"spin", "segments", "time step", "mass ratio", "length", "scheme", "modulus"},
       {{"spin", "time step"}}},
      {"twist struck",
       Level::Twist,
       Dynamics,
       struck_yields,
       over,
       yield_motion,
       {{"load", "time step"}, {"mass ratio", "time step"}}},
      {"twist struck, breaks",
       Level::Twist,
       Dynamics,
       struck_breaks,
       over,
       yield_motion,
       {{"load", "time step"}}},
  };
}

}  // namespace plastica::sweeps::stability
