#pragma once

#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

namespace plastica::testing {

/// Batches of scenes that nobody has thought of: supports, loads, laws, schemes and steps by
/// chance, the same for all cases of a batch, whose numbers differ. Some cannot be run; that is
/// part of the game.
class RandomBatch {
 public:
  explicit RandomBatch(unsigned seed) : random_(seed) {}

  std::vector<BatchCase> make() {
    at_rest_ = chance(0.35);
    in_space_ = chance(0.5);
    duration_ = at_rest_ ? 1.0 : 6e-3;
    BatchCase one;
    one.scene = scene();
    one.options = options();
    std::vector<BatchCase> cases(static_cast<std::size_t>(pick(2, 11)), one);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      cases[i].id = std::to_string(i);
      differ(cases[i].scene);
    }
    return cases;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  int pick(int first, int last) { return std::uniform_int_distribution<int>(first, last)(random_); }
  bool chance(double p) { return between(0.0, 1.0) < p; }
  Place somewhere() { return {between(0.0, 1.0), {}}; }

  History history() {
    const double end = duration_;
    switch (pick(0, 4)) {
      case 0: return History::constant();
      case 1: return History::ramp();
      case 2: return History::sine(end / between(1.0, 4.0), 2.0);
      case 3: return History::smooth_step(0.1 * end, 0.7 * end);
      default: return {{0.0, 0.4 * end, 0.7 * end}, {0.0, 1.0, 0.3}};
    }
  }

  void add_supports(Scene& scene) {
    const auto add = [&](Place at, SupportKind kind) {
      scene.supports.push_back({.at = at, .kind = kind});
    };
    switch (pick(0, 5)) {
      case 0: add(Place::start(), SupportKind::Clamp); break;
      case 1:
        add(Place::start(), SupportKind::Pin);
        add(Place::end(), SupportKind::Roller);
        break;
      case 2:
        add(Place::start(), SupportKind::Clamp);
        add(Place::end(), chance(0.5) ? SupportKind::Clamp : SupportKind::Roller);
        break;
      case 3:
        if (at_rest_) add(Place::end(), SupportKind::Clamp);
        break;
      case 4:
        add({0.3, {}}, SupportKind::Pin);
        add({0.8, {}}, SupportKind::Roller);
        break;
      default:
        add(Place::start(), SupportKind::Clamp);
        add({between(0.3, 1.0), {}}, SupportKind::Elastic);
        scene.supports.back().stiffness = {between(0.0, 1e5), between(0.0, 1e5), 0.0};
        scene.supports.back().rotational_stiffness = {chance(0.5) ? 800.0 : 0.0, 0.0, 0.0};
    }
    if (scene.supports.empty() || chance(0.7)) return;
    Support& hand = scene.supports.back();
    hand.translation = {0.0, between(-0.01, 0.01), 0.0};
    hand.rotation = {chance(0.5) ? between(-0.1, 0.1) : 0.0, 0.0, 0.0};
    hand.history = history();
  }

  Load load() {
    Load load;
    load.at = somewhere();
    if (chance(0.2)) {
      load.at = {0.2, {}};
      load.to = Place{0.9, {}};
    }
    load.force = {in_space_ ? between(-300.0, 300.0) : 0.0, between(-1200.0, 1200.0),
                  chance(0.3) ? between(-2000.0, 2000.0) : 0.0};
    if (chance(0.3)) {
      load.moment = {between(-50.0, 50.0), 0.0, in_space_ ? between(-30.0, 30.0) : 0.0};
    }
    load.follows = chance(0.3);
    load.history = history();
    return load;
  }

  void add_law(Scene& scene) {
    scene.yield_model = chance(0.4) ? YieldModel::Elastic : YieldModel::PerAxis;
    if (scene.yield_model == YieldModel::Elastic) return;
    if (chance(0.3)) scene.material.break_strain = between(1e-3, 0.2);
    Hardening& hardening = scene.material.hardening;
    switch (pick(0, 3)) {
      case 0: return;
      case 1:
        hardening.law = HardeningLaw::Linear;
        hardening.tangent_modulus = between(1e9, 40e9);
        hardening.kinematic_fraction = between(0.0, 1.0);
        return;
      case 2:
        hardening.law = HardeningLaw::VoceChaboche;
        hardening.saturation_stress = between(-30e6, 100e6);
        hardening.saturation_rate = between(0.0, 300.0);
        hardening.backstress_modulus = {between(0.0, 40e9), chance(0.5) ? 9e9 : 0.0, 0.0};
        hardening.backstress_rate = {between(0.0, 500.0), 0.0, 0.0};
        return;
      default:
        hardening.law = HardeningLaw::Multilinear;
        hardening.kinematic_fraction = between(0.0, 1.0);
        hardening.plastic_strain = {1e-3, 5e-3};
        hardening.flow_stress = {300e6, 330e6};
    }
  }

  Scene scene() {
    Scene scene = chain_scene(pick(1, 9));
    scene.material.density = 7850.0;
    add_supports(scene);
    const int loads = pick(at_rest_ ? 1 : 0, 2);
    for (int k = 0; k < loads; ++k) scene.loads.push_back(load());
    if (chance(0.6)) {
      scene.gravity = {0.0, -9.81, 0.0};
      scene.gravity_history = History::constant();
    }
    add_law(scene);
    if (!at_rest_) {
      InitialMotion blow;
      blow.from = {0.4, {}};
      blow.velocity = {in_space_ ? between(-5.0, 5.0) : 0.0, between(-20.0, 20.0), 0.0};
      blow.spin = {between(-10.0, 10.0), 0.0, in_space_ ? between(-5.0, 5.0) : 0.0};
      scene.initial_motions = {blow};
      if (chance(0.3)) scene.masses.push_back({.at = somewhere(), .mass = between(0.1, 2.0)});
    }
    add_probe(scene, ProbeQuantity::Displacement, somewhere(), Component::Y);
    add_probe(scene, ProbeQuantity::Velocity, somewhere(), Component::Size);
    add_probe(scene, ProbeQuantity::Moment, somewhere(), Component::X);
    add_probe(scene, ProbeQuantity::PlasticStrain, somewhere(), Component::X);
    return scene;
  }

  SolverOptions options() {
    SolverOptions options;
    if (at_rest_) {
      options.steps = pick(2, 8);
      options.duration = duration_;
    } else {
      constexpr Scheme kSchemes[] = {Scheme::LinearlyImplicitEuler,
                                     Scheme::LinearlyImplicitMidpoint, Scheme::GeneralizedAlpha,
                                     Scheme::EnergyMomentum};
      options = motion_options(kSchemes[pick(0, 3)], duration_ / pick(8, 40), pick(3, 10));
      options.duration = duration_;
      options.frames = pick(0, 2);
      options.rho_infinity = between(0.0, 1.0);
      if (chance(0.3)) {
        options.damping = chance(0.5) ? Damping::Stiffness : Damping::Relaxation;
        options.damping_time = between(1e-6, 1e-3);
      }
    }
    constexpr InstructionSet kSets[] = {InstructionSet::Auto, InstructionSet::Baseline};
    options.isa = kSets[pick(0, 1)];
    if (chance(0.2)) options.smallest_step = 0.1;
    return options;
  }

  void differ(Scene& scene) {
    scene.material.youngs_modulus *= between(0.8, 1.2);
    scene.material.yield_stress *= between(0.9, 1.15);
    scene.material.density *= between(0.8, 1.2);
    scene.section.height *= between(0.9, 1.1);
    for (Load& load : scene.loads) load.force[1] *= between(0.7, 1.2);
    for (Support& support : scene.supports) {
      support.translation[1] *= chance(0.1) ? 0.0 : between(0.5, 1.5);
    }
    for (InitialMotion& motion : scene.initial_motions) {
      motion.velocity[1] *= chance(0.05) ? 40.0 : between(0.5, 1.5);
    }
  }

  std::mt19937 random_;
  bool at_rest_ = false;
  bool in_space_ = false;
  double duration_ = 0.0;
};

}  // namespace plastica::testing
