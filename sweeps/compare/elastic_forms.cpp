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

Values elastica(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const bool across = beam.force[0] == 0.0 && beam.force[2] == 0.0 && beam.force[1] != 0.0 &&
                      beam.moment == std::array<double, 3>{};
  require_scene(across, "is for a tip force along y");
  const double size = std::abs(beam.force[1]);
  const double load = size * beam.length * beam.length / beam.bending_stiffness;
  require_scene(load <= 1e4, "is for P L^2/(E I) up to 1e4");
  return tip_value(setup, quantity, theory::elastica_tip_force(load), beam.force[1] / size);
}

Values elastica_moment(const Setup& setup, const Quantity& quantity,
                       std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const bool about_x = beam.force == std::array<double, 3>{} && beam.moment[0] != 0.0 &&
                       beam.moment[1] == 0.0 && beam.moment[2] == 0.0;
  require_scene(about_x, "is for a tip moment about x");
  const double size = std::abs(beam.moment[0]);
  const auto tip = theory::elastica_tip_moment(size * beam.length / beam.bending_stiffness);
  return tip_value(setup, quantity, tip, -beam.moment[0] / size);
}

/// The exact tip of a chain under a small tip force: the continuous beam's times its ratio.
Values lumped_chain(const Setup& setup, const Quantity& quantity,
                    std::span<const double> /*time*/) {
  using theory::ChainConvention;
  const Cantilever beam = cantilever_of(setup);
  require_scene(beam.force[1] != 0.0 && beam.moment == std::array<double, 3>{},
                "is for a tip force along y");
  const Probe& probe = end_probe(setup, quantity);
  require_scene(probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y &&
                    is_at_end(probe.at, 1.0, setup),
                "is for the displacement of the tip along y");
  ChainConvention convention = ChainConvention::HalfJoint;
  const EndRule rule = setup.scene.end_rule;
  if (rule == EndRule::Equal) convention = ChainConvention::Weld;
  if (rule == EndRule::ThreeHalves) convention = ChainConvention::ThreeHalvesEnds;
  require_scene(rule != EndRule::Half && setup.scene.formulas == Formulas::Mechanics,
                "is for rules.end_rule half_joint, equal or three_halves");
  const int segments = setup.scene.beam.segments;
  require_scene(segments >= 2, "is for two segments or more");
  const double cube = beam.length * beam.length * beam.length;
  return {theory::tip_force_ratio(convention, segments) * beam.force[1] * cube /
          (3.0 * beam.bending_stiffness)};
}

/// Elementary cases of a bent beam, small displacements.
Values beam(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const BentBeam bent = bent_beam_of(setup);
  require_scene(quantity.kind == QuantityKind::Probe && quantity.take != Take::Curve,
                "is for one number of a probe");
  const Probe& probe = setup.scene.probes[quantity.probe];
  const double at = distance_of(probe.at, setup);
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y) {
    return {theory::beam_deflection(bent.beam, at)};
  }
  if (probe.quantity == ProbeQuantity::Rotation && probe.component == Component::X) {
    return {-theory::beam_slope(bent.beam, at)};
  }
  if (probe.quantity == ProbeQuantity::Reaction && probe.component == Component::Y) {
    const theory::BeamReactions reactions = theory::beam_reactions(bent.beam);
    return {at == 0.0 ? reactions.start_force : reactions.end_force};
  }
  require_scene(probe.quantity == ProbeQuantity::Moment && probe.component == Component::X &&
                    quantity.take == Take::Size,
                "is for displacement or reaction along y, rotation about x, or the size of the "
                "moment about x");
  return {std::abs(theory::beam_moment(bent.beam, at))};
}

Values torsion(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  require_scene(
      beam.force == std::array<double, 3>{} && beam.moment[0] == 0.0 && beam.moment[1] == 0.0,
      "is for a torque at the tip, about z");
  const Probe& probe = end_probe(setup, quantity);
  require_scene(probe.quantity == ProbeQuantity::Rotation && probe.component == Component::Z,
                "is for a rotation about z");
  return {theory::end_twist(setup.scene.section, resolved_shear_modulus(setup.scene.material),
                            distance_of(probe.at, setup), beam.moment[2])};
}

}  // namespace

std::span<const ClosedForm> elastic_forms() {
  static constexpr std::array kForms{
      ClosedForm{"elastica",
                 "cantilever under a tip force along y: tip displacement y, z, or rotation x; "
                 "displacements of any size",
                 elastica},
      ClosedForm{"elastica_moment",
                 "cantilever that a tip moment about x rolls up: tip displacement y, z, or "
                 "rotation x",
                 elastica_moment},
      ClosedForm{"lumped_chain",
                 "the chain itself: tip of a cantilever of N segments under a small tip force",
                 lumped_chain},
      ClosedForm{"beam",
                 "clamped, pinned and free beams under a point force, a moment or an even load, "
                 "small displacements: displacement, rotation, reaction, size of the moment",
                 beam},
      ClosedForm{"torsion", "bar that is clamped and twisted at its end, elastic: rotation z",
                 torsion},
  };
  return kForms;
}

}  // namespace plastica::sweeps
