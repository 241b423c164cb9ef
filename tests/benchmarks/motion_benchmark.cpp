#include <benchmark/benchmark.h>

#include <string>

#include "tests/support/motion_scene.hpp"

/// What a step of a chain in motion costs per segment, by level, scheme and number of segments.
/// Figures come from one run each, so compare ratios.
namespace plastica {
namespace {

/// W1, the soft cantilever that falls by its weight; in space it is struck sideways, too, and in
/// torsion it is turned.
void step(benchmark::State& state) {
  const auto level = static_cast<Level>(state.range(0));
  const auto scheme = static_cast<Scheme>(state.range(1));
  const auto segments = static_cast<int>(state.range(2));
  Scene scene = testing::cantilever_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  InitialMotion turn;
  turn.from = {0.5, {}};
  turn.spin = {0.0, 0.0, 1.0};
  if (level == Level::Twist) scene.initial_motions = {turn};
  if (level != Level::Twist) {
    scene.gravity = {level == Level::Spatial ? 2.0 : 0.0, -9.81, 0.0};
    scene.gravity_history = History::constant();
  }
  constexpr int kSteps = 100;
  SolverOptions options = testing::motion_options(scheme, 1e-3, 1);
  options.duration = kSteps * 1e-3;
  options.level = level;
  const Model model = prepare(scene, options);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  for (auto _ : state) run(model, {}, workspace, response);
  if (response.status != Status::Completed || response.counters.steps != kSteps) {
    state.SkipWithError("did not go to its end");
  }
  state.counters["iterations"] = static_cast<double>(response.counters.iterations) / kSteps;
  // Seconds per segment and step.
  state.counters["per_segment_step"] = benchmark::Counter(
      static_cast<double>(kSteps * segments),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void levels_and_schemes(benchmark::internal::Benchmark* benchmark) {
  for (const Level level : {Level::Twist, Level::Planar, Level::Spatial}) {
    for (int scheme = 0; scheme < 4; ++scheme) {
      for (const int segments : {16, 64, 256, 1024, 4096}) {
        benchmark->Args({static_cast<int>(level), scheme, segments});
      }
    }
  }
}
BENCHMARK(step)->Apply(levels_and_schemes)->ArgNames({"level", "scheme", "segments"});

}  // namespace
}  // namespace plastica
