// Seconds of a fit through a planar three-point bend, 32 segments and 200 load steps: Young's
// modulus, yield stress and break strain from 200 noisy samples. With lanes, and without: a pillar
// that the beam never touches keeps a scene out of them. Compare figures of one run only.

#include <benchmark/benchmark.h>

#include <random>

#include "calibrate/trial/scene_model.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/studies/trips.hpp"

namespace plastica::calibrate {
namespace {

enum class Lanes { Off, On };

WeightedTarget bent_bar(Lanes lanes) {
  constexpr int kSteps = 200;
  plastica::testing::Trip trip =
      plastica::testing::make_trip(plastica::testing::Test::Bend, Analysis::Statics, 32);
  const double last = trip.last();
  trip.target.abscissa.clear();
  for (int i = 1; i <= kSteps; ++i) trip.target.abscissa.push_back(last * i / kSteps);
  trip.target.ordinate.assign(kSteps, 0.0);
  const SceneModel model(
      trip.setup, trip.target,
      {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")});
  const std::vector<double> truth{205e9, 380e6};
  trip.target.ordinate = model.run(truth, 1).front().ordinate;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, 0.005 * trip.target.ordinate.back());
  for (double& force : trip.target.ordinate) force += noise(random);
  trip.target.broke = SceneBreak{last, 0.5 * last / kSteps};
  if (lanes == Lanes::Off) {
    Support pillar = plastica::testing::trips::held(0.25, SupportKind::Pillar);
    pillar.gap = 1.0;
    trip.setup.scene.supports.push_back(pillar);
  }
  return {trip.setup, trip.target};
}

SceneFitOptions all_three() {
  SceneFitOptions options;
  options.parameters = plastica::testing::all_three();
  options.threads = 1;
  options.segments_error = false;  // one fit, not three
  options.starts = 1;
  return options;
}

void scene_fit(benchmark::State& state) {
  const WeightedTarget weighted = bent_bar(state.range(0) == 0 ? Lanes::Off : Lanes::On);
  SceneFitResult fit;
  for (auto _ : state) fit = fit_scene(weighted.setup, weighted.target, all_three());
  if (fit.status != FitStatus::Fitted) state.SkipWithError(fit.reason.c_str());
  state.counters["runs"] = fit.runs;
}

BENCHMARK(scene_fit)->ArgName("lanes")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// The runs of a fit alone: 64 points at once, as a global stage screens them.
void screened_points(benchmark::State& state) {
  constexpr std::size_t kPoints = 64;
  const WeightedTarget weighted = bent_bar(state.range(0) == 0 ? Lanes::Off : Lanes::On);
  const SceneModel model(
      weighted.setup, weighted.target,
      {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")});
  std::vector<double> points;
  for (std::size_t i = 0; i < kPoints; ++i) {
    points.push_back(150e9 + 2e9 * static_cast<double>(i));
    points.push_back(500e6 - 4e6 * static_cast<double>(i));
  }
  for (auto _ : state) benchmark::DoNotOptimize(model.run(points, kPoints, 1));
  state.counters["per_point"] = benchmark::Counter(
      kPoints, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(screened_points)->ArgName("lanes")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// A point and its forward differences: 1, 3, 8 and 21 points at once, for 0, 2, 7 and 20
/// parameters, side by side or as companions.
void slopes(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<std::size_t> leads(state.range(1) == 0 ? 0 : count, 0);
  const WeightedTarget weighted = bent_bar(Lanes::On);
  const SceneModel model(
      weighted.setup, weighted.target,
      {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")});
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(205e9 * (1.0 + 1e-5 * static_cast<double>(i % 2)));
    const std::size_t off = (i + 1) / 2;
    points.push_back(380e6 * (1.0 + 1e-5 * static_cast<double>(off)));
  }
  for (auto _ : state) benchmark::DoNotOptimize(model.run(points, count, 1, nullptr, leads));
}

BENCHMARK(slopes)
    ->ArgNames({"points", "companions"})
    ->ArgsProduct({{1, 3, 8, 21}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace plastica::calibrate
