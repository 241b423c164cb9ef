// Fits per second of a batch of noisy 300-point curves, with one thread and with two, and the
// cost of its parts. Compare figures of one run only: machines differ and are noisy.

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibrate/fit/fit.hpp"
#include "calibrate/problem/misfit.hpp"
#include "calibrate/target/make.hpp"

namespace plastica::calibrate {
namespace {

constexpr std::size_t kSpecimens = 10000;
constexpr int kSamples = 300;

/// Steel-like ideal-plastic curves to 3 % strain with 1 % noise and a break.
std::vector<Curve> make_curves() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Curve> curves(kSpecimens);
  for (Curve& curve : curves) {
    const double yield = 300e6 * (1.0 + 0.1 * normal(random));
    for (int i = 0; i < kSamples; ++i) {
      const double strain = 1e-4 * i;
      curve.strain.push_back(strain);
      curve.stress.push_back(std::min(200e9 * strain, yield) + 0.01 * yield * normal(random));
    }
    curve.strain.push_back(1e-4 * kSamples);
    curve.stress.push_back(0.0);
  }
  return curves;
}

std::vector<Target> make_targets(const std::vector<Curve>& curves) {
  std::vector<Target> targets;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    targets.push_back(make_target("specimen-" + std::to_string(i), curves[i], {}));
  }
  return targets;
}

const std::vector<Target>& targets() {
  static const std::vector<Target> made = make_targets(make_curves());
  return made;
}

FitOptions all_free() {
  FitOptions options;
  for (const char* name : {"youngs_modulus", "yield_stress", "break_strain"}) {
    Parameter p;
    p.field = &find_field(name);
    options.parameters.push_back(p);
  }
  return options;
}

void batch_of_fits(benchmark::State& state) {
  const FitOptions options = all_free();
  std::size_t evaluations = 0;
  // Made, and the memory of a batch touched, before the clock runs.
  fit(targets(), options, {static_cast<int>(state.range(0)), nullptr, {}});
  for (auto _ : state) {
    const auto results = fit(targets(), options, {static_cast<int>(state.range(0)), nullptr, {}});
    evaluations = 0;
    for (const FitResult& result : results) evaluations += result.evaluations();
  }
  state.counters["fits/s"] = benchmark::Counter(
      static_cast<double>(kSpecimens * static_cast<std::size_t>(state.iterations())),
      benchmark::Counter::kIsRate);
  state.counters["per_fit"] = benchmark::Counter(
      static_cast<double>(kSpecimens),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["evaluations/fit"] =
      static_cast<double>(evaluations) / static_cast<double>(kSpecimens);
}
// In CPU time, which other programs do not disturb, and for threads in wall time.
BENCHMARK(batch_of_fits)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK(batch_of_fits)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

/// @param evaluate  of a misfit, at values, with the gradient that is to be filled
template <typename Evaluate>
void measure_evaluations(benchmark::State& state, const Evaluate& evaluate) {
  const bool with_gradient = state.range(0) != 0;
  const FitOptions options = all_free();
  const ParameterSet set(targets()[0], options);
  Misfit misfit(targets()[0], options, set);
  std::vector<double> values;
  for (const std::size_t i : set.active()) values.push_back(set.all()[i].start);
  std::vector<double> gradient(with_gradient ? values.size() : 0);
  const double yield = values[1];
  std::size_t i = 0;
  for (auto _ : state) {
    // Each at a point of its own: the model is not run again where it has just been.
    values[1] = yield * (1.0 + 1e-4 * static_cast<double>(++i % 100));
    benchmark::DoNotOptimize(evaluate(misfit, values, gradient));
  }
}

void evaluation_of_a_cost(benchmark::State& state) {
  measure_evaluations(state, [](Misfit& misfit, const auto& values, auto& gradient) {
    return misfit.cost(values, gradient);
  });
}
BENCHMARK(evaluation_of_a_cost)->ArgName("gradient")->Arg(0)->Arg(1);

/// As a search of ideal plasticity under a strain that only rises sees it.
void evaluation_in_closed_form(benchmark::State& state) {
  measure_evaluations(state, [](Misfit& misfit, const auto& values, auto& gradient) {
    return misfit.search_cost(values, gradient);
  });
}
BENCHMARK(evaluation_in_closed_form)->ArgName("gradient")->Arg(0)->Arg(1);

void making_of_a_target(benchmark::State& state) {
  const std::vector<Curve> curves = make_curves();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_target("specimen", curves[i++ % curves.size()], {}));
  }
}
BENCHMARK(making_of_a_target);

}  // namespace
}  // namespace plastica::calibrate
