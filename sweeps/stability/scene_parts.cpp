#include "sweeps/stability/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plastica::sweeps::stability::parts {
namespace {

constexpr double kDensity = 7850.0;

/// Regions that give every second segment, or of a long chain the outer half, another density.
void weigh(const Knobs& knobs, Scene& scene) {
  if (knobs.mass_ratio == 1.0) return;
  const auto heavy = [&](Place from, Place to) {
    Region region{from, to, scene.section, scene.material};
    region.material.density *= knobs.mass_ratio;
    scene.regions.push_back(region);
  };
  const int n = scene.beam.segments;
  if (n > 64) {
    heavy({0.5, {}}, Place::end());
    return;
  }
  for (int i = 1; i < n; i += 2) heavy({0.0, i}, {0.0, i + 1});
}

}  // namespace

int rounded(double number) { return static_cast<int>(std::lround(number)); }

Numbers::Numbers(const Knobs& knobs)
    : L(knobs.length), h(knobs.length / knobs.slenderness), n(knobs.segments) {
  Section square;
  square.width = square.height = h;
  section = section_properties(square, knobs.poisson_ratio);
  EI = knobs.youngs_modulus * section.second_moment_x;
  GJ = knobs.youngs_modulus / (2.0 * (1.0 + knobs.poisson_ratio)) * section.torsion_constant;
  area = section.area;
  yield = kNominalYield * section.section_modulus_x;
  twist_yield = kNominalYield / std::numbers::sqrt3 * section.torsion_modulus;
  rho_A = kDensity * area;
  rho_I = kDensity * section.second_moment_x;
}

StabilityCase beam(const Knobs& knobs, Level level, YieldModel model) {
  StabilityCase made;
  Scene& scene = made.setup.scene;
  scene.probes.clear();
  scene.material.youngs_modulus = knobs.youngs_modulus;
  scene.material.poisson_ratio = knobs.poisson_ratio;
  scene.material.yield_stress = knobs.yield_stress;
  scene.material.density = kDensity;
  scene.section.width = scene.section.height = knobs.length / knobs.slenderness;
  scene.beam.length = knobs.length;
  scene.beam.segments = rounded(knobs.segments);
  scene.yield_model = model;
  weigh(knobs, scene);
  made.setup.solver.level = level;
  made.setup.solver.frames = 1;
  return made;
}

StabilityCase cantilever(const Knobs& knobs, Level level, YieldModel model) {
  StabilityCase made = beam(knobs, level, model);
  made.setup.scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Clamp});
  return made;
}

std::size_t probe(StabilityCase& made, ProbeQuantity quantity, Place at, Component component) {
  auto& probes = made.setup.scene.probes;
  Probe added{"probe" + std::to_string(probes.size()), quantity, at, component};
  probes.push_back(added);
  return probes.size() - 1;
}

std::size_t probe(StabilityCase& made, EnergyKind energy) {
  const std::size_t number = probe(made, ProbeQuantity::Energy, Place::end(), Component::Y);
  made.setup.scene.probes[number].energy = energy;
  return number;
}

void push(StabilityCase& made, Place at, const std::array<double, 3>& force,
          const std::array<double, 3>& moment, const History& history) {
  Load load;
  load.at = at;
  load.force = force;
  load.moment = moment;
  load.history = history;
  made.setup.scene.loads.push_back(load);
}

void in_motion(StabilityCase& made, const Knobs& knobs, double period) {
  SolverOptions& solver = made.setup.solver;
  solver.analysis = Analysis::Dynamics;
  solver.scheme = static_cast<Scheme>(rounded(knobs.scheme));
  solver.time_step = knobs.time_step > 0.0 ? knobs.time_step : period / knobs.steps_in_period;
  solver.duration = knobs.steps * solver.time_step;
  solver.steps = std::min(rounded(knobs.steps), 50);
  if (knobs.damping > 0.0) {
    // Of a mode of frequency omega, c/c_critical = damping_time omega/2.
    solver.damping = Damping::Stiffness;
    solver.damping_time = knobs.damping * period / std::numbers::pi;
  }
}

double bending_period(const Numbers& beam) {
  constexpr double kRoot = 1.875104068711961;
  return 2.0 * std::numbers::pi * beam.L * beam.L / (kRoot * kRoot) *
         std::sqrt(beam.rho_A / beam.EI);
}

double twisting_period(const Numbers& beam) {
  return 4.0 * beam.L * std::sqrt(2.0 * beam.rho_I / beam.GJ);
}

}  // namespace plastica::sweeps::stability::parts
