#include "sweeps/stability/motion_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sweeps/stability/scene_parts.hpp"

namespace plastica::sweeps::stability::parts {

double free_period(const Numbers& b) {
  constexpr double kRoot = 4.730040744862704;
  return 2.0 * std::numbers::pi * b.L * b.L / (kRoot * kRoot) * std::sqrt(b.rho_A / b.EI);
}

/// The first mode of pinned ends, sin(j pi/N) at node j: with s = sin(pi/(2N)),
/// omega^2 = (E I/l) 16 s^4/l^2 / (rho A l (1 - 2 s^2/3) + 4 s^2 rho I/l), see
/// theory::pinned_chain_frequency_ratio; each rod turns with its section.
StabilityCase vibration_on(const Knobs& knobs, Level level) {
  StabilityCase made = beam(knobs, level, YieldModel::Elastic);
  Scene& scene = made.setup.scene;
  const Numbers b(knobs);
  const int n = rounded(knobs.segments);
  const double l = b.L / b.n;
  const double s = std::sin(std::numbers::pi / (2.0 * b.n));
  const double mass = b.rho_A * l * (1.0 - 2.0 * s * s / 3.0) + 4.0 * s * s * b.rho_I / l;
  const double omega = 4.0 * s * s / l * std::sqrt(b.EI / l / mass);
  in_motion(made, knobs, 2.0 * std::numbers::pi / omega);
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  const double amplitude = 1e-4 * knobs.load * b.L;
  const double speed = amplitude * omega;
  for (int i = 0; i < n; ++i) {
    const double from = speed * std::sin(i * std::numbers::pi / b.n);
    const double to = speed * std::sin((i + 1) * std::numbers::pi / b.n);
    InitialMotion motion{.from = {0.0, i}, .to = {0.0, i + 1}};
    motion.about = {(i + 0.5) / b.n, {}};
    motion.velocity = {0.0, 0.5 * (from + to), 0.0};
    // About x, z turns towards -y.
    motion.spin = {-(to - from) / l, 0.0, 0.0};
    scene.initial_motions.push_back(motion);
  }
  const int middle = n / 2;
  const std::size_t displacement =
      probe(made, ProbeQuantity::Displacement, {0.0, middle}, Component::Y);
  const SolverOptions& solver = made.setup.solver;
  const double phase = omega * solver.time_step;
  const bool damped = knobs.damping > 0.0 || solver.scheme == Scheme::LinearlyImplicitEuler;
  if (!damped && knobs.mass_ratio == 1.0 && knobs.load <= 10.0) {
    const double steps = knobs.steps;
    const double turned = steps * 2.0 * std::atan(0.5 * phase);
    const double size = amplitude * std::sin(middle * std::numbers::pi / b.n);
    const double own = solver.scheme == Scheme::GeneralizedAlpha
                           ? std::min(2.0, steps * phase * phase * phase / 4.0)
                           : 0.0;
    made.expected.references.push_back({.what = "deflection",
                                        .probe = displacement,
                                        .value = size * std::sin(turned),
                                        .size = size,
                                        .tolerance = 0.01 + own,
                                        .continuum = size * std::sin(steps * phase)});
  }
  return made;
}
void fly(StabilityCase& made, const Knobs& knobs, const std::array<double, 3>& spin, double speed) {
  InitialMotion all;
  all.velocity = {0.0, speed, 0.5 * speed};
  all.spin = spin;
  made.setup.scene.initial_motions.push_back(all);
  const Numbers b(knobs);
  const double mass = b.rho_A * b.L * (1.0 + knobs.mass_ratio);
  const double fastest = std::hypot(speed, 0.5 * b.L * std::hypot(spin[0], spin[1], spin[2]));
  const std::size_t y = probe(made, ProbeQuantity::Momentum, Place::end(), Component::Y);
  const std::size_t z = probe(made, ProbeQuantity::Momentum, Place::end(), Component::Z);
  const std::size_t x = probe(made, ProbeQuantity::AngularMomentum, Place::end(), Component::X);
  made.expected.kept.push_back({"momentum along y", y, mass * fastest, kAccurate});
  made.expected.kept.push_back({"momentum along z", z, mass * fastest, kAccurate});
  // About the origin: of the way that it has flown, too.
  const double far = b.L + speed * made.setup.solver.duration;
  made.expected.kept.push_back({"angular momentum", x, mass * fastest * far, kAccurate});
}

StabilityCase struck_of(const Knobs& knobs, YieldModel model, Level level) {
  StabilityCase made = cantilever(knobs, level, model);
  const Numbers b(knobs);
  in_motion(made, knobs, bending_period(b));
  InitialMotion blow;
  blow.from = {0.5, {}};
  const double speed = knobs.load * kNominalYield / std::sqrt(knobs.youngs_modulus * 7850.0);
  blow.velocity = {level == Level::Spatial ? 0.5 * speed : 0.0, -speed, 0.0};
  made.setup.scene.initial_motions.push_back(blow);
  return made;
}
}  // namespace plastica::sweeps::stability::parts
