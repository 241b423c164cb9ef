#include <benchmark/benchmark.h>

#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

/// What a step of an articulated scheme costs per segment, alone and side by side, by instruction
/// set, precision and number of segments.
namespace plastica {
namespace {

/// W1, the soft cantilever that falls by its weight; one sample at the end.
Scene falling_scene(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.material.youngs_modulus = 2e9;
  scene.material.density = 1200.0;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.gravity_history = History::constant();
  return scene;
}

constexpr int kSteps = 1000;

SolverOptions step_options(const benchmark::State& state) {
  const auto scheme = state.range(0) == 1 ? Scheme::ArticulatedEuler : Scheme::ArticulatedMidpoint;
  SolverOptions options = testing::motion_options(scheme, 1e-3, 1);
  options.duration = kSteps * 1e-3;
  options.isa = static_cast<InstructionSet>(state.range(1));
  options.precision = state.range(2) == 8 ? Precision::Double : Precision::Float;
  return options;
}

void count(benchmark::State& state, double scenarios, double segments) {
  using benchmark::Counter;
  state.counters["per_segment_step"] =
      Counter(kSteps * segments * scenarios, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["scenarios"] = Counter(scenarios, Counter::kIsIterationInvariantRate);
}

/// `cases` of one model; 1: alone.
void step(benchmark::State& state) {
  const auto cases = static_cast<std::size_t>(state.range(3));
  const auto segments = static_cast<int>(state.range(4));
  const SolverOptions options = step_options(state);
  if (!has_instruction_set(options.isa)) {
    state.SkipWithError("not on this processor");
    return;
  }
  const Model model = prepare(falling_scene(segments), options);
  BatchOptions alone;
  alone.threads = 1;
  if (cases == 1) {
    Workspace workspace = make_workspace(model);
    Response response = make_response(model);
    for (auto _ : state) run(model, {}, workspace, response);
  } else {
    for (auto _ : state) benchmark::DoNotOptimize(run_batch(model, {}, cases, alone));
  }
  count(state, static_cast<double>(cases), segments);
}

void sets(benchmark::internal::Benchmark* benchmark) {
  for (const int isa : {1, 2, 3}) {
    for (const int order : {1, 2}) {
      for (const int bytes : {8, 4}) {
        for (const int cases : {1, 16}) benchmark->Args({order, isa, bytes, cases, 64});
      }
    }
  }
  for (const int segments : {16, 256, 1024, 4096, 16384, 65536}) {
    for (const int cases : {1, 8}) benchmark->Args({2, 0, 8, cases, segments});
  }
}
BENCHMARK(step)->Apply(sets)->ArgNames({"order", "isa", "bytes", "cases", "segments"});

}  // namespace
}  // namespace plastica
