#include <array>
#include <cmath>
#include <numbers>

#include "plastica/theory/elastica.hpp"
#include "sweeps/stability/base_scene.hpp"
#include "sweeps/stability/scene_parts.hpp"

/// Paths whose end is easily another than the right one: very flexible beams, columns and strips
/// beyond their critical loads, axial force beside bending, parts of other sections wherever they
/// end. They are judged by what the beam does, whatever the number of segments and of steps.
namespace plastica::sweeps::stability {
namespace {

using namespace parts;
using std::numbers::pi;

/// K(m) = R_F(0, 1 - m, 1).
double complete_first(double m) { return theory::carlson_rf(0.0, 1.0 - m, 1.0); }

void set_steps(StabilityCase& made, const Knobs& knobs) {
  made.setup.solver.steps = rounded(knobs.path_steps);
}

/// A cantilever under a force across its tip, P L^2/(E I) = flexibility: the tip turns by no more
/// than a right angle.
StabilityCase flexible(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  set_steps(made, knobs);
  const Numbers b(knobs);
  push(made, Place::end(), {0.0, knobs.flexibility * b.EI / (b.L * b.L), 0.0}, {});
  const auto tip = theory::elastica_tip_force(knobs.flexibility);
  const std::size_t y = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Y);
  const std::size_t z = probe(made, ProbeQuantity::Displacement, Place::end(), Component::Z);
  const std::size_t turn = probe(made, ProbeQuantity::Rotation, Place::end(), Component::X);
  // A fifth of a segment. The chain is of order 2 and comes closer, but where the beam bends within
  // sqrt(E I/P) of the clamp, about a segment: there it is off by up to 0.182 of one, whatever N.
  const double fifth = 0.2 / b.n;
  made.expected.references = {
      {.what = "tip deflection",
       .probe = y,
       .value = tip.deflection * b.L,
       .size = b.L,
       .tolerance = fifth},
      {.what = "tip position",
       .probe = z,
       .value = (tip.position - 1.0) * b.L,
       .size = b.L,
       .tolerance = fifth},
      {.what = "tip slope", .probe = turn, .value = -tip.slope, .size = 1.0, .tolerance = fifth}};
  return made;
}

/// A column with pinned ends under `critical` times Euler's load, with a thousandth of it across
/// its middle: beyond it bends to the side of that force, as the elastica. With P/P_E = (2 K/pi)^2
/// its middle is at k L/K. Source: Timoshenko & Gere, Theory of Elastic Stability, sec. 2.7.
StabilityCase pinned_column(const Knobs& knobs) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  set_steps(made, knobs);
  const Numbers b(knobs);
  const double euler = pi * pi * b.EI / (b.L * b.L);
  const double P = knobs.critical * euler;
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  Support roller{.at = Place::end(), .kind = SupportKind::Roller};
  roller.hold = HeldFreedoms{true, true, false, false, false, false};
  scene.supports.push_back(roller);
  push(made, Place::end(), {0.0, 0.0, -P}, {});
  push(made, {0.5, {}}, {0.0, 1e-3 * P, 0.0}, {});
  const std::size_t middle = probe(made, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
  Reference reference{.what = "deflection of the middle", .probe = middle, .size = b.L};
  if (knobs.critical <= 0.9) {
    // Q L^3/(48 E I) 3 (tan u - u)/u^3, u = pi/2 sqrt(P/P_E).
    const double u = 0.5 * pi * std::sqrt(knobs.critical);
    reference.value = 1e-3 * P * b.L * b.L * b.L / (16.0 * b.EI) * (std::tan(u) - u) / (u * u * u);
    reference.tolerance = 1e-3 + 0.02 / b.n;
  } else if (knobs.critical >= 1.1) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 200; ++i) {
      const double m = 0.5 * (low + high);
      const double K = complete_first(m);
      (4.0 * K * K / (pi * pi) < knobs.critical ? low : high) = m;
    }
    const double m = 0.5 * (low + high);
    reference.value = std::sqrt(m) * b.L / complete_first(m);
    reference.tolerance = 0.03 + 2.0 / (b.n * b.n);
  } else {
    return made;
  }
  made.expected.references.push_back(reference);
  return made;
}

/// The same without any force across: beyond Euler's load straight is unstable.
StabilityCase perfect_column(const Knobs& knobs) {
  StabilityCase made = pinned_column(knobs);
  made.setup.scene.loads.pop_back();
  made.expected.references.clear();
  made.expected.unstable = knobs.critical >= 1.1;
  return made;
}

/// A strip of 1:10, clamped, under a force across its tip in its plane, `critical` times 4.013
/// sqrt(E I GJ)/L^2: beyond, it leaves its plane. Source: Timoshenko & Gere, sec. 6.3.
StabilityCase strip(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  set_steps(made, knobs);
  scene.section.width = 0.1 * scene.section.height;
  const SectionProperties p = section_properties(scene.section, knobs.poisson_ratio);
  const double weak = knobs.youngs_modulus * p.second_moment_y;
  const double torsion =
      knobs.youngs_modulus / (2.0 * (1.0 + knobs.poisson_ratio)) * p.torsion_constant;
  const double L = knobs.length;
  push(made, Place::end(),
       {0.0, knobs.critical * 4.0126 * std::sqrt(weak * torsion) / (L * L), 0.0}, {});
  made.expected.unstable = knobs.critical >= 1.1;
  return made;
}

/// A cantilever that is pulled by `axial` times what it can carry and bent by a moment of twice its
/// plastic one: m = 1 - n^2. So stiff that its shape does not matter.
StabilityCase pulled_hinge(const Knobs& knobs) {
  StabilityCase made = cantilever(knobs, Level::Planar, YieldModel::Interaction);
  Scene& scene = made.setup.scene;
  set_steps(made, knobs);
  scene.material.youngs_modulus *= 1e5;
  scene.yield_cap = YieldCap::FullyPlastic;
  const Numbers b(knobs);
  const double squash = knobs.yield_stress * b.area;
  const double moment = 1.5 * b.yield * knobs.yield_stress / kNominalYield;
  const double n = knobs.axial;
  if (n < 1.0) {
    push(made, Place::end(), {0.0, 0.0, n * squash}, {}, History::constant());
    push(made, Place::end(), {}, {2.0 * moment, 0.0, 0.0});
    made.expected.limit = 0.5 * (1.0 - n * n);
  } else {
    push(made, Place::end(), {0.0, 0.0, n * squash}, {});
    made.expected.limit = 1.0 / n;
  }
  return made;
}

/// A cantilever that is half as deep from `place` on, under a force across its tip; the other way
/// round it is clamped at its end and deep up to there. Deflection of the tip by the unit-load
/// integral of both terms.
StabilityCase stepped_of(const Knobs& knobs, bool exchanged) {
  StabilityCase made = beam(knobs, Level::Planar, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  set_steps(made, knobs);
  const Numbers b(knobs);
  const double at = knobs.place;
  const Place step{exchanged ? 1.0 - at : at, {}};
  const Place free = exchanged ? Place::start() : Place::end();
  scene.supports.push_back(
      {.at = exchanged ? Place::end() : Place::start(), .kind = SupportKind::Clamp});
  Region thin = exchanged ? Region{Place::start(), step, scene.section, scene.material}
                          : Region{step, Place::end(), scene.section, scene.material};
  thin.section.height *= 0.5;
  scene.regions.push_back(thin);
  const double P = 1e-4 * b.EI / (b.L * b.L);
  push(made, free, {0.0, P, 0.0}, {});
  const std::size_t tip = probe(made, ProbeQuantity::Displacement, free, Component::Y);
  const double rest = std::pow(1.0 - at, 3);
  const double beam = P * b.L * b.L * b.L / (3.0 * b.EI) * (1.0 - rest + 8.0 * rest);
  made.expected.references.push_back({.what = "tip deflection",
                                      .probe = tip,
                                      .value = beam,
                                      .tolerance = 1e-4 + 4.0 / (b.n * b.n)});
  return made;
}
StabilityCase stepped(const Knobs& knobs) { return stepped_of(knobs, false); }
StabilityCase stepped_exchanged(const Knobs& knobs) { return stepped_of(knobs, true); }

}  // namespace

std::vector<BaseScene> critical_scenes() {
  using enum Analysis;
  const std::vector<std::string_view> bends{"flexibility", "path steps", "segments"};
  const std::vector<std::string_view> buckles{"critical", "path steps", "segments"};
  Knobs beyond;
  beyond.critical = 2.0;
  return {
      {"planar flexible",
       Level::Planar,
       Statics,
       flexible,
       {},
       bends,
       {{"flexibility", "path steps"}, {"flexibility", "segments"}}},
      {"planar pinned column",
       Level::Planar,
       Statics,
       pinned_column,
       beyond,
       buckles,
       {{"critical", "path steps"}}},
      {"planar perfect column",
       Level::Planar,
       Statics,
       perfect_column,
       {},
       buckles,
       {{"critical", "path steps"}}},
      {"planar strip", Level::Planar, Statics, strip, {}, buckles, {{"critical", "path steps"}}},
      {"planar pulled hinge",
       Level::Planar,
       Statics,
       pulled_hinge,
       {},
       {"axial", "path steps", "segments"},
       {{"axial", "path steps"}}},
      {"planar stepped",
       Level::Planar,
       Statics,
       stepped,
       {},
       {"place", "segments"},
       {{"place", "segments"}}},
      {"planar stepped exchanged",
       Level::Planar,
       Statics,
       stepped_exchanged,
       {},
       {"place", "segments"},
       {{"place", "segments"}}},
  };
}

}  // namespace plastica::sweeps::stability
