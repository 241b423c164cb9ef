#include "calibrate/fit/fitted_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "calibrate/fit/fit_law.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/target/curve_spool.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::calibrate {

FittedCurve fitted_curve(const Target& target, const FitOptions& options, const FitResult& result) {
  Setup setup = options.setup;
  for (const FittedParameter& p : result.parameters) {
    // A break limit that the curve does not show would break the fitted beam at a guess. All else
    // is what the optimizer compared with the curve, determined by it or not.
    if (p.identified || !p.is_break()) set_field(setup, find_field(p.path), p.value);
  }
  Scene& scene = setup.scene;
  take_test(target, scene);
  scene.probes = {{"stress", ProbeQuantity::Stress}};
  scene.on_break = BreakPolicy::CutAll;
  const auto& observed = target.characteristics.observed_break;
  if (observed) scene.drive.strain.push_back(observed->first_broken_strain);
  const std::size_t shown = scene.drive.strain.size();

  // Go on in the last direction until the beam must have broken, to learn at which strain.
  if (scene.material.break_strain || scene.material.break_shear_strain) {
    const double last = scene.drive.strain.back();
    const double limit = std::max(scene.material.break_strain.value_or(0.0),
                                  scene.material.break_shear_strain.value_or(0.0));
    const Material& material = scene.material;
    const double stiffness =
        target.test == Test::Torsion ? resolved_shear_modulus(material) : material.youngs_modulus;
    const double largest = largest_magnitude(target.corrected.stress);
    const double elastic = 4.0 * std::max(largest, material.yield_stress) / stiffness;
    const double before = shown > 1 ? scene.drive.strain[shown - 2] : 0.0;
    const double direction = last == before ? last : last - before;
    scene.drive.strain.push_back(last + std::copysign(4.0 * limit + elastic, direction));
  }
  Response response = simulate(scene, setup.solver);
  FittedCurve fitted;
  Curve& curve = fitted.curve;
  const auto end = static_cast<std::ptrdiff_t>(shown);
  curve.strain.assign(scene.drive.strain.begin(), scene.drive.strain.begin() + end);
  curve.stress.assign(response.probes[0].begin(), response.probes[0].begin() + end);
  // A line to the first broken sample would fall before the break.
  if (observed && response.event && response.event->sample + 1 == shown) {
    const auto add = [](double value, std::vector<double>& values) {
      values.insert(values.end() - 1, 2, value);
    };
    add(response.event->strain, curve.strain);
    add(response.event->stress, curve.stress);
    curve.stress.end()[-2] = 0.0;
  }
  fitted.event = response.event;
  return fitted;
}

Curve remade_curve(const Target& target, const FitOptions& options, const FitResult& result) {
  if (result.fitted.samples() == 0) return {};
  const CorrectedTarget read(target);
  if (options.laws.empty()) return fitted_curve(*read, options, result).curve;
  return fitted_curve(*read, options_of(result.law, options, target.loading), result).curve;
}

bool may_have_curve(const Target& target, const FitResult& result) {
  const std::size_t samples = result.fitted.samples(), measured = target.corrected.samples();
  // The first broken sample, and the model's break before it.
  constexpr std::size_t kMore = 3;
  return samples == 0 || (samples >= measured && samples <= measured + kMore);
}

void count_alone(FitResult& result) {
  Curve counted;
  counted.aside.samples = result.fitted.samples();
  result.fitted = std::move(counted);  // with its memory, which a copy would leave
}

}  // namespace plastica::calibrate
