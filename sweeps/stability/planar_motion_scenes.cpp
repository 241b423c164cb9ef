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

StabilityCase vibration(const Knobs& knobs) { return vibration_on(knobs, Level::Planar); }

/// A cantilever under sudden weight, damped or not.
StabilityCase released(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  in_motion(made, knobs, bending_period(b));
  const double w = 2.0 * knobs.load * b.yield / (b.L * b.L);
  scene.gravity = {0.0, -w / b.rho_A, 0.0};
  scene.gravity_history = History::constant();
  return made;
}

/// The same, damped to rest: the static deflection of the chain.
StabilityCase settles(const Knobs& knobs) {
  StabilityCase made = released(knobs);
  const Numbers b(knobs);
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const double w = 2.0 * knobs.load * b.yield / (b.L * b.L);
  const double small = w * b.L * b.L * b.L / b.EI;
  const double period = bending_period(b);
  const double omega = 2.0 * std::numbers::pi / period;
  // Below critical the amplitude falls as exp(-damping omega t), beyond it slower.
  const double slowest = knobs.damping <= 1.0 ? knobs.damping : 0.5 / knobs.damping;
  const double left = std::exp(-slowest * omega * made.setup.solver.duration);
  if (small < 0.03 && knobs.mass_ratio == 1.0 && left < 1e-3 && knobs.damping > 0.0) {
    const double ratio =
        theory::self_weight_ratio(theory::ChainConvention::HalfJoint, rounded(knobs.segments));
    made.expected.references.push_back({.what = "settled tip",
                                        .probe = tip,
                                        .value = -ratio * small * b.L / 8.0,
                                        .tolerance = 0.01,
                                        .continuum = -small * b.L / 8.0});
  }
  return made;
}

/// A free beam that flies, turns and bends.
StabilityCase flight(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  const double speed = knobs.load * kNominalYield / std::sqrt(knobs.youngs_modulus * 7850.0) * 0.1;
  InitialMotion outer;
  outer.from = {0.5, {}};
  outer.velocity = {0.0, speed, 0.0};
  made.setup.scene.initial_motions.push_back(outer);
  fly(made, knobs, {2.0 * speed / b.L, 0.0, 0.0}, speed);
  return made;
}

/// A straight free beam that spins about its middle stays straight.
StabilityCase spins(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Elastic);
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  fly(made, knobs, {knobs.spin, 0.0, 0.0}, 0.0);
  const std::size_t spin = probe(made, ProbeQuantity::Spin, Place::end(), Component::X);
  made.expected.kept.push_back({"spin", spin, knobs.spin, 1e-2});
  return made;
}

StabilityCase struck(const Knobs& knobs) {
  return struck_of(knobs, YieldModel::Interaction, Level::Planar);
}
StabilityCase struck_per_axis(const Knobs& knobs) {
  return struck_of(knobs, YieldModel::PerAxis, Level::Planar);
}
StabilityCase struck_fibres(const Knobs& knobs) {
  return struck_of(knobs, YieldModel::Fibre, Level::Planar);
}
StabilityCase shatters(const Knobs& knobs) {
  StabilityCase made = struck(knobs);
  made.setup.scene.material.break_strain = 1e-3;
  return made;
}

/// A curved free beam whose every joint goes over its limit in the first steps: neighbours turn
/// against each other.
StabilityCase bursts(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Interaction);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  const int n = rounded(knobs.segments);
  const double speed = knobs.load * kNominalYield / std::sqrt(knobs.youngs_modulus * 7850.0);
  for (int i = 0; i < n; ++i) {
    InitialMotion motion{.from = {0.0, i}, .to = {0.0, i + 1}};
    motion.about = {(i + 0.5) / b.n, {}};
    motion.spin = {(i % 2 == 0 ? 1.0 : -1.0) * speed * b.n / b.L, 0.0, 0.0};
    scene.initial_motions.push_back(motion);
  }
  scene.material.break_strain = 1e-9;
  return made;
}

/// A beam that falls on two pillars.
StabilityCase lands(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  in_motion(made, knobs, free_period(b));
  const double speed = 0.1 * knobs.load * kNominalYield / std::sqrt(knobs.youngs_modulus * 7850.0);
  InitialMotion falls;
  falls.velocity = {0.0, -speed, 0.0};
  scene.initial_motions.push_back(falls);
  for (const double at : {0.25, 1.0}) {
    Support pillar;
    pillar.at = {at, {}};
    pillar.kind = SupportKind::Pillar;
    pillar.gap = 0.3 * speed * free_period(b);
    pillar.restitution = 0.5;
    scene.supports.push_back(pillar);
  }
  return made;
}

/// A force at the tip that turns round after so many steps.
StabilityCase reversed(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Interaction);
  const Numbers b(knobs);
  in_motion(made, knobs, bending_period(b));
  History history;
  history.time = {0.0};
  history.factor = {1.0};
  const double h = made.setup.solver.time_step;
  const int turns = rounded(knobs.steps / knobs.reversal);
  for (int k = 1; k <= turns; ++k) {
    history.time.push_back(k * knobs.reversal * h);
    history.factor.push_back(k % 2 == 0 ? 1.0 : -1.0);
  }
  push(made, Place::end(), {0.0, knobs.load * b.yield / b.L, 0.0}, {}, history);
  return made;
}

/// A straight cantilever on which nothing acts.
StabilityCase rests(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Interaction);
  const Numbers b(knobs);
  in_motion(made, knobs, bending_period(b));
  made.setup.scene.initial_motions.emplace_back();  // of no speed
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Size);
  made.expected.kept.push_back({"tip", tip, b.L, 1e-12});
  return made;
}

}  // namespace

std::vector<BaseScene> planar_motion_scenes() {
  using enum Analysis;
  const std::vector<std::string_view> elastic{"modulus",    "segments", "time step", "slenderness",
                                              "mass ratio", "load",     "poisson",   "damping",
                                              "length",     "scheme"};
  const std::vector<std::string_view> yields{"modulus",    "segments", "time step", "slenderness",
                                             "mass ratio", "load",     "yield",     "poisson",
                                             "damping",    "length",   "scheme"};
  std::vector<std::string_view> reversing = yields;
  reversing.insert(reversing.begin(), "reversal");
  const std::vector<std::string_view> turning{"spin",      "modulus",     "segments",
                                              "time step", "slenderness", "mass ratio",
                                              "length",    "scheme",      "damping"};
  Knobs own;
  own.scheme = 3.0;
  Knobs damped;
  damped.damping = 0.3;
  damped.steps = 1000;
  damped.load = 0.1;
  Knobs blow;
  blow.scheme = 3.0;
  blow.steps_in_period = 1000;
  blow.steps = 1000;
  Knobs burst = blow;
  burst.load = 10.0;
  Knobs ringing;
  ringing.steps_in_period = 1000;
  ringing.steps = 3000;
  Knobs rest;
  rest.segments = 4;
  return {
      {"planar vibration",
       Level::Planar,
       Dynamics,
       vibration,
       own,
       elastic,
       {{"modulus", "time step"}, {"time step", "scheme"}, {"segments", "time step"}}},
      {"planar released",
       Level::Planar,
       Dynamics,
       released,
       {},
       elastic,
       {{"modulus", "time step"},
        {"load", "time step"},
        {"segments", "time step"},
        {"time step", "scheme"}}},
      {"planar settles",
       Level::Planar,
       Dynamics,
       settles,
       damped,
       elastic,
       {{"damping", "time step"}, {"damping", "scheme"}}},
      {"planar flight",
       Level::Planar,
       Dynamics,
       flight,
       own,
       elastic,
       {{"load", "time step"},
        {"mass ratio", "time step"},
        {"time step", "scheme"},
        {"load", "scheme"}}},
      {"planar spin",
       Level::Planar,
       Dynamics,
       spins,
       own,
       turning,
       {{"spin", "time step"}, {"spin", "scheme"}, {"spin", "modulus"}}},
      {"planar struck",
       Level::Planar,
       Dynamics,
       struck,
       blow,
       yields,
       {{"load", "time step"}, {"mass ratio", "load"}, {"load", "scheme"}}},
      {"planar struck per axis",
       Level::Planar,
       Dynamics,
       struck_per_axis,
       blow,
       yields,
       {{"load", "yield"}}},
      {"planar struck fibres",
       Level::Planar,
       Dynamics,
       struck_fibres,
       blow,
       yields,
       {{"load", "time step"}}},
      {"planar shatters",
       Level::Planar,
       Dynamics,
       shatters,
       blow,
       yields,
       {{"load", "time step"}, {"load", "scheme"}}},
      {"planar bursts",
       Level::Planar,
       Dynamics,
       bursts,
       burst,
       yields,
       {{"load", "time step"}, {"load", "segments"}}},
      {"planar lands",
       Level::Planar,
       Dynamics,
       lands,
       ringing,
       elastic,
       {{"load", "time step"}, {"modulus", "time step"}, {"load", "scheme"}}},
      {"planar reversed",
       Level::Planar,
       Dynamics,
       reversed,
       {},
       reversing,
       {{"load", "time step"}, {"reversal", "scheme"}}},
      {"planar rest",
       Level::Planar,
       Dynamics,
       rests,
       rest,
       {"steps", "segments", "time step", "mass ratio", "modulus", "scheme", "length",
        "slenderness"},
       {{"modulus", "time step"}}},
  };
}

}  // namespace plastica::sweeps::stability
