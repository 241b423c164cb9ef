#include <benchmark/benchmark.h>

#include <cmath>

#include "plastica/base/keep_freed_memory.hpp"
#include "plastica/run/batch.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/support/chain.hpp"

/// What whole static paths cost, with the error of each beside it: `run` of a prepared model.
namespace plastica {
namespace {

using testing::cantilever;

/// Runs a model again and again. @return what its first probe says at the end
double run_often(benchmark::State& state, const Scene& scene, const SolverOptions& options) {
  const Model model = prepare(scene, options);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  for (auto _ : state) run(model, {}, workspace, response);
  if (response.status != Status::Completed) state.SkipWithError("not completed");
  state.counters["iterations"] = response.counters.iterations;
  state.counters["steps"] = response.counters.steps;
  return response.probes[0].back();
}

/// A cantilever loaded to 1.2 x first yield and released, by yield model (40 steps).
void bend_and_release(benchmark::State& state) {
  Scene scene = cantilever(160, {0.0, -400.0, 0.0});
  scene.yield_model = static_cast<YieldModel>(state.range(0));
  // A fibre section has no cap of its own.
  if (scene.yield_model != YieldModel::Fibre) scene.yield_cap = YieldCap::FullyPlastic;
  scene.loads[0].history = History::turning_points({1.0, 0.0});
  SolverOptions options;
  options.steps = 40;
  run_often(state, scene, options);
}
BENCHMARK(bend_and_release)
    ->Arg(static_cast<int>(YieldModel::Elastic))
    ->Arg(static_cast<int>(YieldModel::PerAxis))
    ->Arg(static_cast<int>(YieldModel::Fibre));

/// A cantilever of 32 segments under a tip force of P L^2/EI = 2, in one load step; `error` is that
/// of the tip's deflection against the elastica's.
void elastica(benchmark::State& state, Level level) {
  Scene scene = cantilever(32, {});
  scene.material.youngs_modulus = 2e9;
  scene.yield_model = YieldModel::Elastic;
  scene.loads[0].force[1] = -2.0 * 2e9 * std::pow(0.02, 4) / 12.0;
  SolverOptions options;
  options.level = level;
  options.steps = 1;
  options.tolerance = 1e-6;
  const double tip = run_often(state, scene, options);
  constexpr double kTip = 0.4934574804;  // tests/reference/elastica-cantilever
  state.counters["error"] = std::fabs(tip) / kTip - 1.0;
}
BENCHMARK_CAPTURE(elastica, planar, Level::Planar);
BENCHMARK_CAPTURE(elastica, spatial, Level::Spatial);

/// A cantilever bent to 1.2 x first yield and released; `error` is that of the tip's permanent
/// deflection against 0.5247 mm.
void permanent_set(benchmark::State& state) {
  Scene scene = cantilever(static_cast<int>(state.range(0)), {0.0, -400.0, 0.0});
  scene.yield_model = YieldModel::Fibre;
  scene.loads[0].history = History::turning_points({1.0, 0.0});
  SolverOptions options;
  options.level = Level::Planar;
  options.fibres = static_cast<int>(state.range(1));
  options.steps = 2;
  options.tolerance = 1e-7;
  const double tip = run_often(state, scene, options);
  state.counters["error"] = std::fabs(tip) / 0.5247e-3 - 1.0;
}
BENCHMARK(permanent_set)->ArgsProduct({{16, 32, 64}, {12, 20, 40}});

/// 4 096 cantilevers, each with a modulus, yield stress and force of its own, bent in 20 recorded
/// steps, as scenes of their own: laid out, run and handed over one by one or as a batch.
void bent_batch(benchmark::State& state, Level level, YieldModel model) {
  constexpr std::size_t kCases = 4096;
  keep_freed_memory();  // as the command does
  const bool together = state.range(0) == 1;
  Scene scene = cantilever(64, {0.0, -400.0, 0.0});
  if (level == Level::Spatial) scene.loads[0].force = {300.0, -400.0, 0.0};
  scene.yield_model = model;
  scene.yield_cap = YieldCap::FullyPlastic;
  BatchCase one;
  one.options.level = level;
  one.options.frames = 1;
  const auto make = [&](std::size_t i) {
    BatchCase made = one;
    made.scene = scene;
    made.scene.material.youngs_modulus *= 1.0 + 1e-4 * static_cast<double>(i);
    made.scene.material.yield_stress *= 1.0 + 5e-5 * static_cast<double>(i);
    made.scene.loads[0].force[1] *= 1.0 + 2e-5 * static_cast<double>(i);
    return made;
  };
  double iterations = 0.0;
  const auto take = [&](std::size_t, BatchRow&& row) {
    if (row.response.status != Status::Completed) state.SkipWithError("not completed");
    iterations += row.response.counters.iterations;
  };
  BatchOptions options;
  options.threads = 1;
  for (auto _ : state) {
    iterations = 0.0;
    if (together) {
      run_batch(kCases, make, take, options);
    } else {
      for (std::size_t i = 0; i < kCases; ++i) take(i, run_case(make(i)));
    }
  }
  state.counters["iterations"] = iterations / kCases;
  state.counters["per_scenario"] = benchmark::Counter(
      kCases, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(bent_batch, planar_elastic, Level::Planar, YieldModel::Elastic)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together")
    ->Iterations(1);
BENCHMARK_CAPTURE(bent_batch, planar_yielding, Level::Planar, YieldModel::PerAxis)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together")
    ->Iterations(1);
BENCHMARK_CAPTURE(bent_batch, spatial_elastic, Level::Spatial, YieldModel::Elastic)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together")
    ->Iterations(1);
BENCHMARK_CAPTURE(bent_batch, spatial_yielding, Level::Spatial, YieldModel::PerAxis)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together")
    ->Iterations(1);

}  // namespace
}  // namespace plastica
