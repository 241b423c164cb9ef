#include <benchmark/benchmark.h>

#include <cmath>

#include "plastica/run/simulate.hpp"
#include "tests/support/chain.hpp"

/// What one Newton iteration of a chain costs per segment, by level and number of segments: the
/// slope of log time over log N is 1 for an O(N) recursion. Figures come from one run each, so
/// compare ratios.
namespace plastica {
namespace {

using testing::cantilever;
using testing::SolvedChain;

/// A bent elastic cantilever, solved from straight again and again.
template <template <class> class Level, bool kElastic>
void newton_iteration(benchmark::State& state, const chain::View<Level<double>>& view) {
  const auto segments = static_cast<int>(state.range(0));
  const double bending = 200e9 * std::pow(0.02, 4) / 12.0;
  Scene scene = cantilever(segments, {0.0, -0.3 * bending, 0.0});
  if (Level<double>::kRotations == 3) scene.loads[0].force[0] = 0.2 * bending;
  scene.loads[0].moment = {0.0, 0.0, 100.0};
  SolvedChain<Level<double>, kElastic, law::ElasticSection<double>> solved(
      scene, material_values(scene.material), view);
  double iterations = 0.0;
  for (auto _ : state) {
    solved.work.resize(solved.build.chain);
    const auto outcome = solved.go_to(1.0, 1);
    iterations += outcome.iterations + 1;
    benchmark::DoNotOptimize(outcome.imbalance);
  }
  // Seconds per segment and iteration.
  state.counters["per_segment_iteration"] = benchmark::Counter(
      iterations * segments, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void twist(benchmark::State& state) { newton_iteration<chain::Twist, false>(state, {}); }
void planar(benchmark::State& state) { newton_iteration<chain::Planar, false>(state, {1}); }
void planar_elastic(benchmark::State& state) { newton_iteration<chain::Planar, true>(state, {1}); }
void spatial(benchmark::State& state) { newton_iteration<chain::Spatial, false>(state, {}); }
void spatial_elastic(benchmark::State& state) { newton_iteration<chain::Spatial, true>(state, {}); }

BENCHMARK(twist)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(planar)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(planar_elastic)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(spatial)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(spatial_elastic)->RangeMultiplier(4)->Range(16, 4096);

/// A whole path: a cantilever loaded to 1.2 x first yield and released, by yield model (40 steps).
void bend_and_release(benchmark::State& state) {
  Scene scene = cantilever(160, {0.0, -400.0, 0.0});
  scene.yield_model = static_cast<YieldModel>(state.range(0));
  // A fibre section has no cap of its own.
  if (scene.yield_model != YieldModel::Fibre) scene.yield_cap = YieldCap::FullyPlastic;
  scene.loads[0].history = History::turning_points({1.0, 0.0});
  SolverOptions options;
  options.steps = 40;
  const Model model = prepare(scene, options);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  for (auto _ : state) run(model, {}, workspace, response);
  state.counters["iterations"] = response.counters.iterations;
}
BENCHMARK(bend_and_release)
    ->Arg(static_cast<int>(YieldModel::Elastic))
    ->Arg(static_cast<int>(YieldModel::PerAxis))
    ->Arg(static_cast<int>(YieldModel::Fibre));

}  // namespace
}  // namespace plastica
