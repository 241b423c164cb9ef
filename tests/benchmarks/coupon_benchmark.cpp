#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <vector>

#include "plastica/run/simulate.hpp"

/// Nanoseconds of one curve of 300 samples: what a fit pays for each evaluation.
namespace plastica {
namespace {

constexpr int kSamples = 300;

/// A tension test to 5 % strain. `noise` shakes the strain as an extensometer does, so that
/// samples on the plateau load and unload without order.
Scene tension(HardeningLaw law, double noise) {
  Scene scene;
  scene.material.hardening.law = law;
  scene.material.hardening.tangent_modulus = 1.2e9;
  scene.material.hardening.kinematic_fraction = 0.4;
  scene.material.hardening.saturation_stress = 120e6;
  scene.material.hardening.saturation_rate = 25.0;
  if (law == HardeningLaw::VoceChaboche) {
    scene.material.hardening.backstress_modulus = {8e9, 0.0, 0.0};
    scene.material.hardening.backstress_rate = {90.0, 0.0, 0.0};
  }
  unsigned random = 12345;
  for (int i = 1; i <= kSamples; ++i) {
    random = random * 1664525U + 1013904223U;
    const double shake = noise * (static_cast<double>(random >> 8U) / 16777216.0 - 0.5);
    scene.drive.strain.push_back(0.05 * i / kSamples + shake);
  }
  return scene;
}

void evaluate(benchmark::State& state, HardeningLaw law, double noise) {
  const std::vector<std::string> parameters{"yield_stress", "youngs_modulus"};
  const Model model = prepare(tension(law, noise), {}, parameters);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  double yield = 300e6;
  for (auto _ : state) {
    yield = yield < 400e6 ? yield + 1e5 : 300e6;
    const double values[] = {yield, 200e9};
    run(model, values, workspace, response);
    benchmark::DoNotOptimize(response.probes[0].data());
    benchmark::ClobberMemory();
  }
}

void differentiate(benchmark::State& state, HardeningLaw law,
                   const std::vector<std::string>& parameters, double noise) {
  const Model model = prepare(tension(law, noise), {}, parameters);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  Sensitivity sensitivity = make_sensitivity(model);
  std::vector<double> values{300e6, 200e9, 1.1e9};
  if (law == HardeningLaw::VoceChaboche) values[2] = 100e6;
  values.resize(parameters.size());
  for (auto _ : state) {
    values[0] = values[0] < 400e6 ? values[0] + 1e5 : 300e6;
    run_sensitivity(model, values, workspace, response, sensitivity);
    benchmark::DoNotOptimize(sensitivity.stress.data());
    benchmark::ClobberMemory();
  }
}

constexpr double kSmooth = 0.0;
constexpr double kNoisy = 1e-3;
const std::vector<std::string> kTwo{"yield_stress", "youngs_modulus"};
const std::vector<std::string> kThree{"yield_stress", "youngs_modulus", "tangent_modulus"};
const std::vector<std::string> kThreeOfVoce{"yield_stress", "youngs_modulus", "saturation_stress"};

BENCHMARK_CAPTURE(evaluate, ideal, HardeningLaw::Ideal, kSmooth);
BENCHMARK_CAPTURE(evaluate, ideal_noisy, HardeningLaw::Ideal, kNoisy);
BENCHMARK_CAPTURE(evaluate, linear, HardeningLaw::Linear, kSmooth);
BENCHMARK_CAPTURE(evaluate, linear_noisy, HardeningLaw::Linear, kNoisy);
BENCHMARK_CAPTURE(evaluate, voce, HardeningLaw::VoceChaboche, kSmooth);
BENCHMARK_CAPTURE(differentiate, ideal_two, HardeningLaw::Ideal, kTwo, kSmooth);
BENCHMARK_CAPTURE(differentiate, ideal_two_noisy, HardeningLaw::Ideal, kTwo, kNoisy);
BENCHMARK_CAPTURE(differentiate, linear_two, HardeningLaw::Linear, kTwo, kSmooth);
BENCHMARK_CAPTURE(differentiate, linear_three, HardeningLaw::Linear, kThree, kSmooth);
BENCHMARK_CAPTURE(differentiate, linear_three_noisy, HardeningLaw::Linear, kThree, kNoisy);
BENCHMARK_CAPTURE(differentiate, voce_two, HardeningLaw::VoceChaboche, kTwo, kSmooth);
BENCHMARK_CAPTURE(differentiate, voce_three, HardeningLaw::VoceChaboche, kThreeOfVoce, kSmooth);

}  // namespace
}  // namespace plastica
