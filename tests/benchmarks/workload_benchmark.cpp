#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/theory/elastica.hpp"
#include "sweeps/run/sweep_run.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/released_cantilever.hpp"

/// Whole runs through the public interface, each with its error as a counter beside its time, so
/// that the cheapest setting within an error can be chosen afterwards: what
/// tests/benchmarks/README.md calls W1 to W4, and a sweep. A setting that cannot be run says so and
/// is left out.
namespace plastica {
namespace {

Setup setup_of(Scene scene, Level level) {
  Setup setup;
  setup.scene = std::move(scene);
  setup.solver.level = level;
  return setup;
}

/// Runs a model again and again. @return the last response; its samples are 0 if it cannot be run
Response run_again(benchmark::State& state, const Setup& setup) {
  Response response;
  try {
    const Model model = prepare(setup.scene, setup.solver);
    Workspace workspace = make_workspace(model);
    response = make_response(model);
    for (auto _ : state) run(model, {}, workspace, response);
  } catch (const InputError& error) {
    state.SkipWithError(error.what());
    return {};
  }
  if (response.status != Status::Completed) {
    state.SkipWithError(std::string(name_of(response.status)).c_str());
    response.samples = 0;
  }
  return response;
}

Setup released(Level level, std::string_view scheme, int segments, int steps) {
  Setup setup = setup_of(testing::released_cantilever(segments), level);
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.duration = 1.0;
  setup.solver.time_step = 1.0 / steps;
  setup.solver.steps = 100;  // the tip every 10 ms
  setup.solver.frames = 1;
  set_field(setup, find_field("solver.scheme"), std::string(scheme));
  return setup;
}

/// Rms of a tip's history off the reference's, over the static sag.
double history_error(const Response& response) {
  static const testing::ReferenceTable kTable("w1-cantilever-history/tip.csv");
  constexpr double kSag = 0.022063903;
  const std::size_t samples = response.samples;
  double squares = 0.0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    // Between the table's milliseconds a straight line is off by 1e-4 of the sag.
    const double at = 1e3 * response.chain.time[i];
    const auto row = static_cast<std::size_t>(at);
    if (row + 1 >= kTable.rows()) continue;
    const double part = at - static_cast<double>(row);
    const double expected = (1.0 - part) * kTable.at("tip_deflection_m", row) +
                            part * kTable.at("tip_deflection_m", row + 1);
    const double off = -response.probes[0][i] - expected;
    squares += off * off;
    ++counted;
  }
  return std::sqrt(squares / static_cast<double>(counted)) / kSag;
}

/// W1: the soft cantilever that is let go, one second.
void w1(benchmark::State& state, Level level, const std::string& scheme) {
  const auto segments = static_cast<int>(state.range(0));
  const auto steps = static_cast<int>(state.range(1));
  const Response response = run_again(state, released(level, scheme, segments, steps));
  if (response.samples == 0) return;
  state.counters["error"] = history_error(response);
  state.counters["per_segment_step"] = benchmark::Counter(
      static_cast<double>(segments) * steps,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void count_scenarios(benchmark::State& state, std::size_t scenarios) {
  state.counters["per_scenario"] = benchmark::Counter(
      static_cast<double>(scenarios),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// A modulus for each scenario, the first one that of W1 [Pa].
std::vector<double> moduli(std::size_t scenarios) {
  std::vector<double> values(scenarios);
  for (std::size_t i = 0; i < scenarios; ++i) {
    values[i] = 2e9 * (1.0 + 0.1 * static_cast<double>(i) / static_cast<double>(scenarios));
  }
  return values;
}

std::vector<BatchCase> released_cases(Level level, const std::string& scheme, int segments,
                                      int steps, std::size_t scenarios) {
  const Setup setup = released(level, scheme, segments, steps);
  std::vector<BatchCase> cases;
  for (const double modulus : moduli(scenarios)) {
    cases.push_back({std::to_string(cases.size()), setup.scene, setup.solver});
    cases.back().scene.material.youngs_modulus = modulus;
  }
  return cases;
}

/// W1 as a batch, a modulus for each: parameters of one model, or scenes of their own that are laid
/// out one by one.
void w1_batch(benchmark::State& state, Level level, const std::string& scheme) {
  const auto steps = static_cast<int>(state.range(0));
  const bool scenes = state.range(1) != 0;
  constexpr std::size_t kScenarios = 256;
  const Setup setup = released(level, scheme, 64, steps);
  const std::vector<std::string> parameters{"material.youngs_modulus"};
  const Model model = prepare(setup.scene, setup.solver, parameters);
  const std::vector<double> values = moduli(kScenarios);
  const std::vector<BatchCase> cases = released_cases(level, scheme, 64, steps, kScenarios);
  Response first;
  for (auto _ : state) {
    first = scenes ? run_batch(cases, {.threads = 1}).front().response
                   : run_batch(model, values, kScenarios, {.threads = 1}).front();
  }
  if (first.status != Status::Completed) {
    state.SkipWithError(std::string(name_of(first.status)).c_str());
    return;
  }
  state.counters["error"] = history_error(first);
  count_scenarios(state, kScenarios);
}

/// W4: a batch of W1 at 32 segments and 1 ms, all with moduli of their own; in lanes where there
/// are any, or one after the other.
void w4(benchmark::State& state, Level level, const std::string& scheme) {
  const auto threads = static_cast<int>(state.range(0));
  const auto scenarios = static_cast<std::size_t>(state.range(1));
  const bool together = state.range(2) != 0;
  const std::vector<BatchCase> cases = released_cases(level, scheme, 32, 1000, scenarios);
  for (auto _ : state) {
    Status status = Status::Completed;
    if (together) {
      const auto take = [&](std::size_t, BatchRow&& row) {
        if (row.response.status != Status::Completed) status = row.response.status;
      };
      run_batch(scenarios, [&](std::size_t i) { return cases[i]; }, take, {.threads = threads});
    } else {
      for (const BatchCase& one : cases) {
        const BatchRow row = run_case(one);
        if (row.response.status != Status::Completed) status = row.response.status;
      }
    }
    if (status != Status::Completed) {
      state.SkipWithError(std::string(name_of(status)).c_str());
      return;
    }
  }
  count_scenarios(state, scenarios);
}

/// W2: the same beam with a tip force of 2 EI/L^2, at rest; in space the force stands askew, so
/// that both axes bend.
void w2(benchmark::State& state, Level level) {
  Scene scene = testing::cantilever_scene(static_cast<int>(state.range(0)));
  scene.material.youngs_modulus = 2e9;
  const double force = 2.0 * testing::bending_stiffness_of(scene);
  const double askew = level == Level::Spatial ? 0.6 : 0.0;
  const double down = std::sqrt(1.0 - askew * askew);
  scene.loads.push_back({.force = {askew * force, -down * force, 0.0}});
  for (const Component c : {Component::X, Component::Y, Component::Z}) {
    testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), c);
  }
  Setup setup = setup_of(scene, level);
  setup.solver.steps = static_cast<int>(state.range(1));
  setup.solver.frames = 1;
  const Response response = run_again(state, setup);
  if (response.samples == 0) return;
  const auto exact = theory::elastica_tip_force(2.0);
  const double across = std::hypot(testing::last_of(response, 0), testing::last_of(response, 1));
  const double along = -testing::last_of(response, 2);
  state.counters["error"] = std::max(std::fabs(across / exact.deflection - 1.0),
                                     std::fabs(along / (1.0 - exact.position) - 1.0));
  state.counters["iterations"] = response.counters.iterations;
}

/// Fractions of segments that grow from the clamp to the tip by this ratio in all.
std::vector<double> graded(int segments, double ratio) {
  std::vector<double> fractions;
  double sum = 0.0;
  for (int i = 0; i < segments; ++i) {
    fractions.push_back(segments == 1 ? 1.0 : std::pow(ratio, i / (segments - 1.0)));
    sum += fractions.back();
  }
  for (double& fraction : fractions) fraction /= sum;
  return fractions;
}

/// W3: a steel cantilever loaded to 1.2 times first yield and released, in fibres.
void w3(benchmark::State& state) {
  const auto segments = static_cast<int>(state.range(0));
  Scene scene = testing::cantilever_scene(segments);
  scene.yield_model = YieldModel::Fibre;
  scene.beam.segment_fractions = graded(segments, static_cast<double>(state.range(1)));
  scene.loads.push_back({.force = {0.0, -1.2 * testing::yield_moment_of(scene), 0.0},
                         .history = History::turning_points({1.0, 0.0})});
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  Setup setup = setup_of(scene, Level::Planar);
  setup.solver.fibres = static_cast<int>(state.range(2));
  setup.solver.steps = static_cast<int>(state.range(3));
  setup.solver.frames = 1;
  const Response response = run_again(state, setup);
  if (response.samples == 0) return;
  constexpr double kKept = 0.5247e-3;  // with finite rotations
  state.counters["error"] = std::fabs(-testing::last_of(response, 0) / kKept - 1.0);
  state.counters["iterations"] = response.counters.iterations;
}
BENCHMARK(w3)
    ->ArgNames({"segments", "growth", "fibres", "steps"})
    ->ArgsProduct({{16, 20, 24, 32}, {6, 10}, {20, 30, 40}, {2}})
    ->Args({160, 1, 40, 40});

/// A shipped sweep, all of its cases; without files and report.
void sweep(benchmark::State& state, const std::string& file) {
  const sweeps::Sweep read =
      sweeps::read_sweep_file(std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/" + file);
  std::size_t cases = 0;
  for (auto _ : state) {
    sweeps::SweepRun run(read, {.threads = 1});
    cases = run.run().size();
  }
  state.counters["per_case"] =
      benchmark::Counter(static_cast<double>(cases), benchmark::Counter::kIsIterationInvariantRate |
                                                         benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(sweep, cantilever_deflection, "cantilever_deflection.toml")
    ->Unit(benchmark::kMillisecond);

/// Every scheme that there is, by its name in files.
const bool kRegistered = [] {
  const std::array<std::pair<const char*, Level>, 2> levels{
      {{"planar", Level::Planar}, {"spatial", Level::Spatial}}};
  for (const auto& [name, level] : levels) {
    benchmark::RegisterBenchmark((std::string("w2/") + name).c_str(), w2, level)
        ->ArgNames({"segments", "steps"})
        ->ArgsProduct({{16, 32}, {1, 2, 4, 8}});
    for (const std::string_view choice : find_field("solver.scheme").choices) {
      const std::string scheme(choice);
      benchmark::RegisterBenchmark(("w1/" + std::string(name) + "/" + scheme).c_str(), w1, level,
                                   scheme)
          ->ArgNames({"segments", "steps"})
          ->ArgsProduct({{64}, {500, 800, 1000, 2000}})
          ->Unit(benchmark::kMillisecond);
      if (!scheme.ends_with("midpoint")) continue;
      // The general step takes longer.
      const bool articulated = scheme.starts_with("articulated");
      const auto batch = [&, &level_name = name, &of = level](std::vector<std::int64_t> threads,
                                                              std::int64_t scenarios,
                                                              std::int64_t together) {
        return benchmark::RegisterBenchmark(
                   ("w4/" + std::string(level_name) + "/" + scheme).c_str(), w4, of, scheme)
            ->ArgNames({"threads", "scenarios", "together"})
            ->ArgsProduct({std::move(threads), {scenarios}, {together}})
            ->Unit(benchmark::kMillisecond);
      };
      if (!articulated) {
        batch({1}, 64, 1);
        batch({1}, 16, 0);
        continue;
      }
      batch({1}, 4096, 1);
      batch({1, 2}, 4096, 1)->UseRealTime();
      batch({1}, 512, 0);
      benchmark::RegisterBenchmark(("w1_batch/" + std::string(name) + "/" + scheme).c_str(),
                                   w1_batch, level, scheme)
          ->ArgNames({"steps", "scenes"})
          ->ArgsProduct({{500, 800, 1000}, {0, 1}})
          ->Unit(benchmark::kMillisecond);
    }
  }
  return true;
}();

}  // namespace
}  // namespace plastica
