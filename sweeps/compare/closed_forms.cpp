#include "sweeps/compare/closed_forms.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "plastica/theory/beam_vibration.hpp"
#include "plastica/theory/elastica.hpp"
#include "sweeps/compare/scene_parts.hpp"

namespace plastica::sweeps {
namespace {

using Values = std::vector<double>;

/// A force across the beam's end bends it in the y-z plane.
Values elastica(const Setup& setup, const Quantity& quantity, std::span<const double> /*time*/) {
  const Cantilever beam = cantilever_of(setup);
  const Probe& probe = end_probe(setup, quantity);
  const bool across = beam.force[0] == 0.0 && beam.force[2] == 0.0 && beam.force[1] != 0.0 &&
                      beam.moment == std::array<double, 3>{};
  require_scene(across, "is for a tip force along y");
  const double size = std::abs(beam.force[1]);
  const double sign = beam.force[1] / size;
  const auto tip =
      theory::elastica_tip_force(size * beam.length * beam.length / beam.bending_stiffness);
  const bool at_tip = probe.at.fraction == 1.0 || probe.at.segment == setup.scene.beam.segments;
  require_scene(at_tip, "is for a probe at the beam's end");
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y) {
    return {sign * tip.deflection * beam.length};
  }
  if (probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Z) {
    return {(tip.position - 1.0) * beam.length};
  }
  require_scene(probe.quantity == ProbeQuantity::Rotation && probe.component == Component::X,
                "is for the displacement along y or z, or the rotation about x");
  return {-sign * tip.slope};
}

Values cantilever_frequency(const Setup& setup, const Quantity& quantity,
                            std::span<const double> /*time*/) {
  require_scene(quantity.kind == QuantityKind::NaturalFrequency,
                "is for quantity = \"natural_frequency\"");
  const Cantilever beam = cantilever_of(setup);
  const double density = setup.scene.material.density;
  theory::VibratingBeam vibrating{beam.length, beam.bending_stiffness, density * beam.section.area};
  if (setup.solver.rotary_inertia == RotaryInertia::On) {
    vibrating.rotary_inertia = density * beam.section.second_moment_x;
  }
  const double omega = theory::rayleigh_cantilever_frequency(quantity.mode, vibrating);
  return {omega / (2.0 * std::numbers::pi)};
}

constexpr std::array kForms{
    ClosedForm{"elastica",
               "cantilever under a tip force along y: tip displacement y, z, or rotation x; "
               "displacements of any size",
               elastica},
    ClosedForm{"cantilever_frequency",
               "natural frequencies of a planar cantilever, with rotary inertia where it is on",
               cantilever_frequency},
};

}  // namespace

std::span<const ClosedForm> closed_forms() { return kForms; }

const ClosedForm& find_closed_form(std::string_view name, const SourceLocation& where) {
  std::string all;
  for (const ClosedForm& form : closed_forms()) {
    if (form.name == name) return form;
    all += (all.empty() ? "" : ", ") + std::string(form.name);
  }
  throw InputError(where, "error.against", "theory:" + std::string(name),
                   "is not a closed form; there are " + all);
}

}  // namespace plastica::sweeps
