#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "plastica/theory/lumped_chain.hpp"
#include "sweeps/stability/base_scene.hpp"
#include "sweeps/stability/motion_parts.hpp"
#include "sweeps/stability/scene_parts.hpp"

namespace plastica::sweeps::stability {

namespace {

using namespace parts;

/// Forces along x and y, and a torque, at the tip.
StabilityCase forces_of(const Knobs& knobs, YieldModel model) {
  StabilityCase made = cantilever(knobs, Level::Spatial, model);
  const Numbers b(knobs);
  const double P = knobs.load * b.yield / b.L;
  push(made, Place::end(), {0.6 * P, 0.8 * P, 0.0}, {0.0, 0.0, 0.2 * knobs.load * b.twist_yield});
  return made;
}
StabilityCase forces(const Knobs& knobs) {
  StabilityCase made = forces_of(knobs, YieldModel::Elastic);
  made.expected.may_reverse = true;  // a torque about an axis that stays
  const Numbers b(knobs);
  const double P = knobs.load * b.yield / b.L;
  const double alpha = P * b.L * b.L / b.EI;
  const std::size_t x = probe(made, ProbeQuantity::Displacement, Place::end(), Component::X);
  const std::size_t y = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  if (alpha < 0.1) {
    // The torque gives the last joint the half segment at the tip as well: with P h there and an
    // arm of h it adds P h (h/2) h/(E I), 3/(2 N^3) of P L^3/(3 E I).
    const double ratio =
        theory::tip_force_ratio(theory::ChainConvention::HalfJoint, rounded(knobs.segments)) +
        1.5 / (b.n * b.n * b.n);
    const double unit = P * b.L * b.L * b.L / (3.0 * b.EI);
    for (const auto& [number, fraction] : {std::pair{x, 0.6}, std::pair{y, 0.8}}) {
      made.expected.references.push_back({.what = "tip deflection",
                                          .probe = number,
                                          .value = ratio * fraction * unit,
                                          .size = unit,
                                          .tolerance = 1e-8 + alpha * 0.1 + alpha * alpha,
                                          .continuum = fraction * unit});
    }
  }
  return made;
}
StabilityCase interaction(const Knobs& knobs) { return forces_of(knobs, YieldModel::Interaction); }
StabilityCase per_axis(const Knobs& knobs) {
  StabilityCase made = forces_of(knobs, YieldModel::PerAxis);
  const Numbers b(knobs);
  const double limit = knobs.yield_stress / kNominalYield / knobs.load / 0.8;
  const double bent = b.yield * knobs.yield_stress / kNominalYield * b.L / b.EI;
  if (limit < 1.0 && bent < 0.1) made.expected.limit = limit;
  return made;
}
StabilityCase conservative(const Knobs& knobs) {
  return forces_of(knobs, YieldModel::Conservative);
}
StabilityCase fibres_in_space(const Knobs& knobs) {
  StabilityCase made = forces_of(knobs, YieldModel::Fibre);
  made.setup.solver.fibres = 8;  // far beyond yield a grid of forty takes minutes
  return made;
}

/// A follower force on an arc of 45 degrees, out of its plane.
StabilityCase arc(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Spatial, YieldModel::Elastic);
  const Numbers b(knobs);
  made.setup.scene.beam.shape = BeamShape::Arc;
  made.setup.scene.beam.arc_angle = 0.25 * std::numbers::pi;
  push(made, Place::end(), {knobs.load * b.yield / b.L, 0.0, 0.0}, {});
  return made;
}

/// A follower force across the tip.
StabilityCase follower(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Spatial, YieldModel::Elastic);
  const Numbers b(knobs);
  push(made, Place::end(),
       {0.6 * knobs.load * b.yield / b.L, 0.8 * knobs.load * b.yield / b.L, 0.0}, {});
  made.setup.scene.loads.back().follows = true;
  return made;
}

StabilityCase vibrates_in_space(const Knobs& knobs) { return vibration_on(knobs, Level::Spatial); }
StabilityCase struck_in_space(const Knobs& knobs) {
  return struck_of(knobs, YieldModel::Interaction, Level::Spatial);
}
StabilityCase shatters_in_space(const Knobs& knobs) {
  StabilityCase made = struck_in_space(knobs);
  made.setup.scene.material.break_strain = 1e-3;
  return made;
}
StabilityCase flies_in_space(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Spatial, YieldModel::Elastic);
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  const double speed = knobs.load * kNominalYield / std::sqrt(knobs.youngs_modulus * 7850.0) * 0.1;
  InitialMotion outer;
  outer.from = {0.5, {}};
  outer.velocity = {0.5 * speed, speed, 0.0};
  outer.spin = {0.0, 0.0, speed / b.L};
  made.setup.scene.initial_motions.push_back(outer);
  fly(made, knobs, {2.0 * speed / b.L, -speed / b.L, 0.5 * speed / b.L}, speed);
  return made;
}
StabilityCase spins_in_space(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Spatial, YieldModel::Elastic);
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  fly(made, knobs, {knobs.spin, 0.0, 0.1 * knobs.spin}, 0.0);
  return made;
}

}  // namespace

std::vector<BaseScene> spatial_scenes() {
  using enum Analysis;
  const std::vector<std::string_view> elastic{"modulus", "segments", "slenderness",
                                              "load",    "poisson",  "length"};
  const std::vector<std::string_view> yields{"modulus", "segments", "slenderness", "load",
                                             "yield",   "poisson",  "length"};
  const std::vector<std::string_view> motion{"modulus",    "segments", "time step", "slenderness",
                                             "mass ratio", "load",     "poisson",   "damping",
                                             "length",     "scheme"};
  const std::vector<std::string_view> yielding{"modulus",    "segments", "time step", "slenderness",
                                               "mass ratio", "load",     "yield",     "poisson",
                                               "damping",    "length",   "scheme"};
  const std::vector<std::string_view> turning{"spin",        "modulus",    "segments", "time step",
                                              "slenderness", "mass ratio", "length",   "scheme"};
  Knobs own;
  own.scheme = 3.0;
  Knobs blow;
  blow.scheme = 3.0;
  blow.steps_in_period = 1000;
  blow.steps = 1000;
  Knobs over;
  over.load = 2.0;
  return {
      {"spatial tip force",
       Level::Spatial,
       Statics,
       forces,
       {},
       elastic,
       {{"modulus", "segments"}, {"slenderness", "load"}}},
      {"spatial arc", Level::Spatial, Statics, arc, {}, elastic, {{"load", "segments"}}},
      {"spatial follower", Level::Spatial, Statics, follower, {}, elastic, {{"load", "segments"}}},
      {"spatial interaction",
       Level::Spatial,
       Statics,
       interaction,
       over,
       yields,
       {{"load", "yield"}}},
      {"spatial per axis", Level::Spatial, Statics, per_axis, over, yields, {{"load", "yield"}}},
      {"spatial conservative",
       Level::Spatial,
       Statics,
       conservative,
       over,
       yields,
       {{"load", "segments"}}},
      {"spatial fibres", Level::Spatial, Statics, fibres_in_space, {}, yields, {{"load", "yield"}}},
      {"spatial vibration",
       Level::Spatial,
       Dynamics,
       vibrates_in_space,
       own,
       motion,
       {{"time step", "scheme"}}},
      {"spatial flight",
       Level::Spatial,
       Dynamics,
       flies_in_space,
       own,
       motion,
       {{"load", "time step"}, {"load", "scheme"}}},
      {"spatial spin",
       Level::Spatial,
       Dynamics,
       spins_in_space,
       own,
       turning,
       {{"spin", "time step"}, {"spin", "scheme"}}},
      {"spatial struck",
       Level::Spatial,
       Dynamics,
       struck_in_space,
       blow,
       yielding,
       {{"load", "time step"}, {"load", "scheme"}}},
      {"spatial shatters",
       Level::Spatial,
       Dynamics,
       shatters_in_space,
       blow,
       yielding,
       {{"load", "time step"}}},
  };
}

}  // namespace plastica::sweeps::stability
