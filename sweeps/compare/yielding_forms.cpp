#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "plastica/theory/cantilever.hpp"
#include "plastica/theory/limit_load.hpp"
#include "plastica/theory/lumped_chain.hpp"
#include "plastica/theory/uniaxial.hpp"
#include "sweeps/compare/form_lists.hpp"
#include "sweeps/compare/scene_parts.hpp"

namespace plastica::sweeps {
namespace {

using Values = std::vector<double>;

/// The largest moment of an ideal joint.
double cap_of(const Setup& setup, const SectionProperties& section) {
  const bool whole = setup.scene.yield_model == YieldModel::Fibre ||
                     setup.scene.yield_cap == YieldCap::FullyPlastic;
  return setup.scene.material.yield_stress *
         (whole ? section.plastic_section_modulus_x : section.section_modulus_x);
}

bool is_ideal(const Setup& setup) {
  return setup.scene.material.hardening.law == HardeningLaw::Ideal &&
         setup.scene.material.rate.law == RateLaw::None &&
         setup.scene.yield_model != YieldModel::Elastic;
}

Values limit_load(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  require_scene(quantity.kind == QuantityKind::LimitLoad, "is for quantity = \"limit_load\"");
  require_scene(is_ideal(setup), "is for ideal plasticity");
  Setup unit = setup;
  if (unit.scene.loads.size() == 1) unit.scene.loads[0].history = History::constant();
  unit.scene.gravity_history = History::constant();
  unit.solver.duration = 1.0;
  const BentBeam bent = bent_beam_of(unit);  // the load at the factor 1
  const theory::BeamLoad& load = bent.beam.load;
  const double cap = cap_of(setup, bent.section);
  if (load.distributed != 0.0) {
    return {theory::limit_distributed(bent.beam.ends, cap, bent.beam.length) /
            std::abs(load.distributed)};
  }
  require_scene(load.force != 0.0, "is for a force along y");
  return {theory::limit_force(bent.beam.ends, cap, bent.beam.length, load.position) /
          std::abs(load.force)};
}

/// Prager and Hodge's cantilever, under its load or after it.
Values elastoplastic_cantilever(const Setup& setup, const Quantity& quantity,
                                std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const Probe& probe = end_probe(setup, quantity);
  require_scene(setup.scene.section.shape == SectionShape::Rectangle && is_ideal(setup),
                "is for a rectangle and ideal plasticity");
  require_scene(probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y &&
                    is_at_end(probe.at, 1.0, setup),
                "is for the displacement of the tip along y");
  const Load& load = setup.scene.loads[0];
  require_scene(load.force[1] != 0.0 && load.force[0] == 0.0 && load.force[2] == 0.0 &&
                    load.moment == std::array<double, 3>{},
                "is for a tip force along y");
  const auto [least, largest] =
      std::minmax_element(load.history.factor.begin(), load.history.factor.end());
  const double last = load.history.at(end_time(setup));
  require_scene(*least >= 0.0 && (last == *largest || last == 0.0),
                "is for a load that ends at its largest, or at zero after it");
  const double yield_force =
      setup.scene.material.yield_stress * beam.section.section_modulus_x / beam.length;
  const double ratio = *largest * std::abs(load.force[1]) / yield_force;
  require_scene(ratio <= 1.5, "is for loads up to 1.5 times that of first yield");
  const double yield_tip =
      yield_force * beam.length * beam.length * beam.length / (3.0 * beam.bending_stiffness);
  const double tip =
      last == 0.0 ? theory::residual_tip_ratio(ratio) : theory::tip_deflection_ratio(ratio);
  return {std::copysign(yield_tip * tip, load.force[1])};
}

/// The rotation at which a hinge of ideal plasticity breaks.
Values hinge_break(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Scene& scene = setup.scene;
  require_scene(quantity.kind == QuantityKind::Probe && quantity.take == Take::Size &&
                    scene.probes[quantity.probe].quantity == ProbeQuantity::PlasticAngle &&
                    scene.probes[quantity.probe].component == Component::X,
                "is for the size of a plastic angle about x");
  const std::optional<double> limit =
      scene.break_limit_x ? scene.break_limit_x : scene.material.break_strain;
  require_scene(is_ideal(setup) && limit && scene.regions.empty(),
                "is for ideal plasticity with a break strain");
  const SectionProperties section = section_properties(scene.section, scene.material.poisson_ratio);
  const double depth = 2.0 * section.outer_distance_x;
  const double hinge = scene.hinge_length.value_or(depth);
  require_scene(hinge > 0.0, "is for a hinge length above 0");
  return {
      theory::hinge_break(*limit, depth, hinge, cap_of(setup, section), scene.beam.length).angle};
}

/// Stress of a coupon that is only ever stretched.
Values uniaxial(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Scene& scene = setup.scene;
  require_scene(scene.is_coupon() && scene.drive.deformation == Deformation::Tension &&
                    std::is_sorted(scene.drive.strain.begin(), scene.drive.strain.end()) &&
                    scene.drive.strain.front() >= 0.0,
                "is for a coupon in rising tension");
  const Material& m = scene.material;
  require_scene(m.rate.law == RateLaw::None, "is for a material without a rate law");
  if (quantity.kind == QuantityKind::BreakStrain || quantity.kind == QuantityKind::BreakLoad) {
    require_scene(m.break_strain.has_value(), "is for a material with a break strain");
    const double stress = theory::monotonic_stress(*m.break_strain, m);
    return {quantity.kind == QuantityKind::BreakLoad ? stress
                                                     : *m.break_strain + stress / m.youngs_modulus};
  }
  require_scene(end_probe(setup, quantity).quantity == ProbeQuantity::Stress && !m.break_strain,
                "is for its stress without a break strain, or the strain or load at its break");
  return {theory::tension_stress(scene.drive.strain.back(), m)};
}

}  // namespace

std::span<const ClosedForm> yielding_forms() {
  static constexpr std::array kForms{
      ClosedForm{"limit_load",
                 "limit_load of clamped, pinned and free beams under a point force, an even load "
                 "or weight",
                 limit_load},
      ClosedForm{"elastoplastic_cantilever",
                 "tip of a cantilever of rectangular section beyond first yield, or what stays of "
                 "it after release; small displacements",
                 elastoplastic_cantilever, true, true},
      ClosedForm{"hinge_break", "rotation at which a plastic hinge breaks", hinge_break},
      ClosedForm{
          "uniaxial",
          "coupon in tension: stress at the end, ideal or with linear hardening; break_strain "
          "and break_load, all laws",
          uniaxial},
  };
  return kForms;
}

}  // namespace plastica::sweeps
