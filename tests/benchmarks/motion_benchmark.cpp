#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
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

/// 64 steel cantilevers of 32 segments, struck so that they yield, each with numbers of its own;
/// stepped together in lanes, or one by one.
void struck_batch(benchmark::State& state, Level level, Scheme scheme) {
  constexpr std::size_t kCases = 64;
  const bool together = state.range(0) == 1;
  Scene scene = testing::struck_scene(32, 15.0, YieldModel::PerAxis);
  if (level == Level::Spatial) scene.initial_motions[0].velocity[0] = 8.0;
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  std::vector<BatchCase> cases(kCases);
  for (std::size_t i = 0; i < kCases; ++i) {
    cases[i].scene = scene;
    cases[i].scene.material.yield_stress *= 1.0 + 1e-3 * static_cast<double>(i);
    cases[i].options = testing::motion_options(scheme, 2e-5, 20);
    cases[i].options.duration = 0.02;
    cases[i].options.level = level;
  }
  for (auto _ : state) {
    std::vector<BatchRow> rows;
    if (together) {
      rows = run_batch(cases, {.threads = 1});
    } else {
      for (const BatchCase& one : cases) rows.push_back(run_case(one));
    }
    for (const BatchRow& row : rows) {
      if (row.response.status != Status::Completed) state.SkipWithError("not completed");
    }
  }
  state.counters["per_scenario"] = benchmark::Counter(
      kCases, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(struck_batch, planar_implicit, Level::Planar, Scheme::LinearlyImplicitMidpoint)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together");
BENCHMARK_CAPTURE(struck_batch, spatial_implicit, Level::Spatial, Scheme::LinearlyImplicitMidpoint)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together");
BENCHMARK_CAPTURE(struck_batch, planar_alpha, Level::Planar, Scheme::GeneralizedAlpha)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together");
BENCHMARK_CAPTURE(struck_batch, spatial_alpha, Level::Spatial, Scheme::GeneralizedAlpha)
    ->Arg(0)
    ->Arg(1)
    ->ArgName("together");

}  // namespace
}  // namespace plastica
