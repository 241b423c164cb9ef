#include <benchmark/benchmark.h>

#include <cmath>

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

}  // namespace
}  // namespace plastica
