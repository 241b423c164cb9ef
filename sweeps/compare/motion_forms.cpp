#include <array>
#include <cmath>
#include <numbers>

#include "plastica/run/chain_model.hpp"
#include "plastica/run/simulate.hpp"
#include "plastica/theory/beam_vibration.hpp"
#include "sweeps/compare/form_lists.hpp"
#include "sweeps/compare/scene_parts.hpp"

namespace plastica::sweeps {
namespace {

using Values = std::vector<double>;

constexpr int kModes = 40;  ///< of a released beam: the terms fall as the fifth power

bool is_clamped_alone(const Setup& setup) {
  const Scene& scene = setup.scene;
  require_scene(scene.masses.empty(), "is for a beam without point masses");
  return !scene.is_coupon() && scene.supports.size() == 1 && scene.regions.empty() &&
         scene.supports[0].kind == SupportKind::Clamp && !scene.supports[0].moves() &&
         is_at_end(scene.supports[0].at, 0.0, setup) && scene.beam.shape == BeamShape::Straight;
}

/// @param about_x  about which axis of the section it bends, else about y
theory::VibratingBeam vibrating_beam(const Setup& setup, bool about_x = true) {
  require_scene(is_clamped_alone(setup),
                "is for a straight, even beam with a clamp at its start as its one support");
  const Scene& scene = setup.scene;
  const auto section = section_properties(scene.section, scene.material.poisson_ratio);
  const double second_moment = about_x ? section.second_moment_x : section.second_moment_y;
  theory::VibratingBeam beam;
  beam.length = scene.beam.length;
  beam.bending_stiffness = scene.material.youngs_modulus * second_moment;
  beam.mass_per_length = scene.material.density * section.area;
  if (setup.solver.rotary_inertia == RotaryInertia::On) {
    beam.rotary_inertia = scene.material.density * second_moment;
  }
  return beam;
}

Values cantilever_frequency(const Setup& setup, const Quantity& quantity,
                            std::span<const double> /*time*/) {
  require_scene(quantity.kind == QuantityKind::NaturalFrequency,
                "is for quantity = \"natural_frequency\"");
  // In space the modes of both planes and of twist are counted together.
  const Model model = prepare(setup.scene, setup.solver);
  require_scene(model.level == Level::Planar,
                "is for a beam that bends in a plane, solver.level = \"planar\"");
  const double omega = theory::rayleigh_cantilever_frequency(
      quantity.mode, vibrating_beam(setup, model.chain->across == 1));
  return {omega / (2.0 * std::numbers::pi)};
}

Values torsion_frequency(const Setup& setup, const Quantity& quantity,
                         std::span<const double> /*time*/) {
  const Scene& scene = setup.scene;
  require_scene(quantity.kind == QuantityKind::NaturalFrequency,
                "is for quantity = \"natural_frequency\"");
  require_scene(is_clamped_alone(setup),
                "is for a straight, even beam with a clamp at its start as its one support");
  require_scene(prepare(scene, setup.solver).level == Level::Twist,
                "is for a beam that is only twisted, solver.level = \"twist\"");
  const auto section = section_properties(scene.section, scene.material.poisson_ratio);
  const double stiffness = resolved_shear_modulus(scene.material) * section.torsion_constant;
  const double inertia =
      scene.material.density * (section.second_moment_x + section.second_moment_y);
  return {
      theory::clamped_free_torsion_frequency(quantity.mode, scene.beam.length, stiffness, inertia) /
      (2.0 * std::numbers::pi)};
}

Values released_cantilever(const Setup& setup, const Quantity& quantity,
                           std::span<const double> time) {
  const Scene& scene = setup.scene;
  require_scene(quantity.is_curve(), "is for take = \"curve\"");
  const theory::VibratingBeam beam = vibrating_beam(setup);
  const Probe& probe = scene.probes[quantity.probe];
  require_scene(probe.quantity == ProbeQuantity::Displacement && probe.component == Component::Y &&
                    is_at_end(probe.at, 1.0, setup),
                "is for the displacement of the tip along y");
  const bool sudden = scene.gravity[0] == 0.0 && scene.gravity[2] == 0.0 && scene.loads.empty() &&
                      scene.gravity_history.factor == std::vector<double>{1.0} &&
                      scene.initial_motions.empty() && setup.solver.analysis == Analysis::Dynamics;
  require_scene(sudden, "is for a motion under constant gravity along y, from rest");
  // Each mode swings to twice its part of the moment at rest, w L^2/2 at the clamp, and all these
  // parts have one sign.
  require_elastic(setup,
                  std::abs(scene.gravity[1]) * beam.mass_per_length * beam.length * beam.length);
  Values values;
  for (const double t : time) {
    values.push_back(theory::released_cantilever_tip(beam, scene.gravity[1], t, kModes));
  }
  return values;
}

}  // namespace

std::span<const ClosedForm> motion_forms() {
  static constexpr std::array kForms{
      ClosedForm{"cantilever_frequency",
                 "natural frequencies of a planar cantilever, with rotary inertia where it is on",
                 cantilever_frequency, false, true},
      ClosedForm{"torsion_frequency", "natural frequencies of a clamped bar that is only twisted",
                 torsion_frequency},
      ClosedForm{"released_cantilever",
                 "tip of a cantilever that is let go straight under gravity along y, over time; "
                 "small displacements, no rotary inertia",
                 released_cantilever, false, true},
  };
  return kForms;
}

}  // namespace plastica::sweeps
