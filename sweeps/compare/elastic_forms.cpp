#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/theory/elastica.hpp"
#include "plastica/theory/lumped_chain.hpp"
#include "plastica/theory/torsion_elastic.hpp"
#include "sweeps/compare/form_lists.hpp"
#include "sweeps/compare/scene_parts.hpp"

namespace plastica::sweeps {
namespace {

using Values = std::vector<double>;

/// What a probe at the tip sees of a bent cantilever.
/// @param sign  +1 if the tip moves along +y
Values tip_value(const Setup& setup, const Quantity& quantity, const theory::ElasticaTip& tip,
                 double sign) {
  const Probe& probe = end_probe(setup, quantity);
  const double length = setup.scene.beam.length;
  require_scene(is_at_end(probe.at, 1.0, setup), "is for a probe at the beam's end");
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y) {
    return {sign * tip.deflection * length};
  }
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Z) {
    return {(tip.position - 1.0) * length};
  }
  require_scene(probe.quantity == ProbeQuantity::Rotation && probe.component == Component::X,
                "is for the displacement along y or z, or the rotation about x");
  return {-sign * tip.slope};
}

const History& history_of(const Scene& scene) {
  return scene.loads.empty() ? scene.gravity_history : scene.loads[0].history;
}

/// The largest size of the load's factor over that at the end.
double most_of_run(const Setup& setup) {
  const History& history = history_of(setup.scene);
  return largest_factor(history, setup) / std::abs(history.at(end_time(setup)));
}

/// The largest size of the moment along a beam under a small load.
double largest_moment(const theory::BeamCase& beam) {
  double largest = std::abs(theory::beam_moment(beam, beam.load.position * (1.0 - 1e-12)));
  constexpr int kPlaces = 400;
  for (int i = 0; i <= kPlaces; ++i) {
    largest = std::max(largest, std::abs(theory::beam_moment(beam, beam.length * i / kPlaces)));
  }
  return largest;
}

/// Refuses a bent beam that yields at any time of its run, be it let go at the end.
void require_elastic_run(const Setup& setup) {
  if (setup.scene.yield_model == YieldModel::Elastic) return;
  Setup unit = setup;
  unit.scene.gravity_history = History::constant();
  for (Load& load : unit.scene.loads) load.history = History::constant();
  unit.solver.duration = 1.0;
  require_elastic(setup, largest_factor(history_of(setup.scene), setup) *
                             largest_moment(bent_beam_of(unit).beam));
}

Values elastica(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const bool across = beam.force[0] == 0.0 && beam.force[2] == 0.0 && beam.force[1] != 0.0 &&
                      beam.moment == std::array<double, 3>{};
  require_scene(across, "is for a tip force along y");
  const double size = std::abs(beam.force[1]);
  const double load = size * beam.length * beam.length / beam.bending_stiffness;
  require_scene(load <= 1e4, "is for P L^2/(E I) up to 1e4");
  const theory::ElasticaTip tip = theory::elastica_tip_force(load);
  require_elastic(setup, most_of_run(setup) * size * tip.position * beam.length);
  return tip_value(setup, quantity, tip, beam.force[1] / size);
}

Values elastica_moment(const Setup& setup, const Quantity& quantity,
                       std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const bool about_x = beam.force == std::array<double, 3>{} && beam.moment[0] != 0.0 &&
                       beam.moment[1] == 0.0 && beam.moment[2] == 0.0;
  require_scene(about_x, "is for a tip moment about x");
  const double size = std::abs(beam.moment[0]);
  require_elastic(setup, most_of_run(setup) * size);
  const auto tip = theory::elastica_tip_moment(size * beam.length / beam.bending_stiffness);
  return tip_value(setup, quantity, tip, -beam.moment[0] / size);
}

/// How theory names the chain of a scene, and its N.
struct NamedChain {
  theory::ChainConvention convention = theory::ChainConvention::HalfJoint;
  int count = 0;
};

NamedChain chain_of(const Setup& setup) {
  using theory::ChainConvention;
  const Scene& scene = setup.scene;
  require_scene(scene.formulas == Formulas::Mechanics && scene.beam.segment_fractions.empty() &&
                    scene.beam.joint_lengths.empty(),
                "is for rules.formulas = \"mechanics\" and segments that the rule divides");
  NamedChain chain{ChainConvention::HalfJoint, scene.beam.segments};
  if (scene.end_rule == EndRule::Equal) chain.convention = ChainConvention::Clamp;
  if (scene.end_rule == EndRule::ThreeHalves) chain.convention = ChainConvention::ThreeHalvesEnds;
  // Two of the segments are half as long.
  if (scene.end_rule == EndRule::Half) chain = {ChainConvention::HalfEnds, scene.beam.segments - 1};
  require_scene(chain.count >= 2, "is for more segments");
  return chain;
}

/// The exact tip of a chain under a small load: the continuous beam's times its ratio.
Values lumped_chain(const Setup& setup, const Quantity& quantity,
                    std::span<const double> /*time*/) {
  const BentBeam bent = bent_beam_of(setup);
  require_scene(bent.beam.ends == theory::BeamEnds::ClampedFree, "is for a cantilever");
  const theory::BeamLoad& load = bent.beam.load;
  require_scene(load.distributed != 0.0 || load.position == bent.beam.length,
                "is for a load at the tip, or an even one");
  const Probe& probe = end_probe(setup, quantity);
  require_scene(probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y &&
                    is_at_end(probe.at, 1.0, setup),
                "is for the displacement of the tip along y");
  require_elastic_run(setup);
  const auto [convention, count] = chain_of(setup);
  // What each part of the load does to the continuous beam.
  const auto tip = [&](const theory::BeamLoad& part) {
    theory::BeamCase one = bent.beam;
    one.load = part;
    return theory::beam_deflection(one, one.length);
  };
  // With half joints and a moment at the tip the last joint, l from it, has the tip's l/2, too:
  // l/2 M(l) l/EI more, over the whole deflections P L^3/3EI, M L^2/2EI and q L^4/8EI.
  const bool bare = convention == theory::ChainConvention::HalfJoint && load.moment != 0.0;
  const double l = bare ? 1.0 / count : 0.0;
  return {(theory::tip_force_ratio(convention, count) + 1.5 * l * l * l) *
              tip({load.position, load.force}) +
          (theory::tip_moment_ratio(convention, count) + l * l) *
              tip({load.position, 0.0, load.moment}) +
          (theory::self_weight_ratio(convention, count) + 2.0 * l * l * l * l) *
              tip({0.0, 0.0, 0.0, load.distributed})};
}

/// Elementary cases of a bent beam, small displacements.
Values beam(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const BentBeam bent = bent_beam_of(setup);
  const Scene& scene = setup.scene;
  const History& history = history_of(scene);
  const bool sizes = quantity.take == Take::Size;
  require_scene(
      quantity.kind == QuantityKind::Probe &&
          (quantity.take == Take::End ||
           (sizes && largest_factor(history, setup) == std::abs(history.at(end_time(setup))))),
      "is for a probe at the end of the run, or its size where the load is largest there");
  const Probe& probe = scene.probes[quantity.probe];
  require_elastic_run(setup);
  const double at = distance_of(probe.at, setup);
  const auto taken = [&](double value) { return Values{sizes ? std::abs(value) : value}; };
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y) {
    return taken(theory::beam_deflection(bent.beam, at));
  }
  if (probe.quantity == ProbeQuantity::Rotation && probe.component == Component::X) {
    return taken(-theory::beam_slope(bent.beam, at));
  }
  if (probe.quantity == ProbeQuantity::Reaction && probe.component == Component::Y) {
    const theory::BeamReactions reactions = theory::beam_reactions(bent.beam);
    return taken(at == 0.0 ? reactions.start_force : reactions.end_force);
  }
  require_scene(probe.quantity == ProbeQuantity::Moment && probe.component == Component::X && sizes,
                "is for displacement or reaction along y, rotation about x, or the size of the "
                "moment about x");
  return {std::abs(theory::beam_moment(bent.beam, at))};
}

/// A twisted bar: Saint-Venant's, beyond first yield that of a circle with ideal plasticity.
Values torsion(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  require_scene(
      beam.force == std::array<double, 3>{} && beam.moment[0] == 0.0 && beam.moment[1] == 0.0,
      "is for a torque at the tip, about z");
  const Scene& scene = setup.scene;
  const Probe& probe = end_probe(setup, quantity);
  require_scene(probe.quantity == ProbeQuantity::Rotation && probe.component == Component::Z,
                "is for a rotation about z");
  const double torque = beam.moment[2];
  const double shear_modulus = resolved_shear_modulus(scene.material);
  const double elastic =
      theory::end_twist(scene.section, shear_modulus, distance_of(probe.at, setup), torque);
  if (scene.yield_model == YieldModel::Elastic) return {elastic};
  const double first_yield =
      resolved_shear_yield_stress(scene.material) * beam.section.torsion_modulus;
  const double largest =
      largest_factor(scene.loads[0].history, setup) * std::abs(scene.loads[0].moment[2]);
  if (largest <= first_yield) return {elastic};
  const double ratio = std::abs(torque) / first_yield;
  require_scene(scene.section.shape == SectionShape::Circle &&
                    scene.material.hardening.law == HardeningLaw::Ideal &&
                    scene.material.rate.law == RateLaw::None && ratio < 4.0 / 3.0 &&
                    std::abs(torque) == largest,
                "is for torques up to first yield; of a solid circle with ideal plasticity for "
                "rising ones up to 4/3 of it");
  // T/T_y = 4/3 (1 - 1/(4 t^3)), solved for the twist; the elastic twist is that of t = T/T_y.
  return {elastic / ratio / std::cbrt(4.0 - 3.0 * ratio)};
}

}  // namespace

std::span<const ClosedForm> elastic_forms() {
  static constexpr std::array kForms{
      ClosedForm{"elastica",
                 "cantilever under a tip force along y: tip displacement y, z, or rotation x; "
                 "displacements of any size",
                 elastica, true, true},
      ClosedForm{"elastica_moment",
                 "cantilever that a tip moment about x rolls up: tip displacement y, z, or "
                 "rotation x",
                 elastica_moment, true, true},
      ClosedForm{"lumped_chain",
                 "the chain itself: tip displacement y of a cantilever of N segments under a small "
                 "tip force, tip moment, even load or weight",
                 lumped_chain, true, true},
      ClosedForm{
          "beam",
          "clamped, pinned and free beams under a point force, a moment, an even load or "
          "weight, small displacements: displacement, rotation, reaction, size of the moment",
          beam, true, true},
      ClosedForm{"torsion",
                 "bar that is clamped and twisted at its end: rotation z; elastic, or a solid "
                 "circle beyond first yield",
                 torsion, true},
  };
  return kForms;
}

}  // namespace plastica::sweeps
