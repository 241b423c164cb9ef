#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "plastica/chain/lane_fields.hpp"
#include "plastica/law/fibre_grid.hpp"
#include "plastica/law/interaction.hpp"
#include "plastica/solve/lane_newton.hpp"
#include "tests/support/chain.hpp"

/// What one Newton iteration of a chain costs per segment, by level, law and number of segments:
/// the slope of log time over log N is 1 for an O(N) recursion. Figures come from one run each, so
/// compare ratios.
namespace plastica {
namespace {

using testing::cantilever;
using testing::SolvedChain;

using Ideal = law::IdealPlastic<double>;

/// Seconds per segment and iteration.
void count(benchmark::State& state, double iterations, int segments) {
  state.counters["per_segment_iteration"] = benchmark::Counter(
      iterations * segments, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

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
  count(state, iterations, segments);
}

void twist(benchmark::State& state) { newton_iteration<chain::Twist, false>(state, {}); }
void planar(benchmark::State& state) { newton_iteration<chain::Planar, false>(state, {1}); }
void planar_elastic(benchmark::State& state) { newton_iteration<chain::Planar, true>(state, {1}); }
void spatial(benchmark::State& state) { newton_iteration<chain::Spatial, false>(state, {}); }
void spatial_elastic(benchmark::State& state) { newton_iteration<chain::Spatial, true>(state, {}); }

/// The same side by side, by instruction set (0: the widest): iterations at the equilibrium, each
/// of which does what all do.
template <template <class> class Level>
void newton_lanes(benchmark::State& state, const chain::View<Level<double>>& view,
                  solve::LaneNewtonTable::Make const (&makes)[solve::kLaneLaws]) {
  const auto segments = static_cast<int>(state.range(0));
  const double bending = 200e9 * std::pow(0.02, 4) / 12.0;
  Scene scene = cantilever(segments, {0.0, -0.3 * bending, 0.0});
  if (Level<double>::kRotations == 3) scene.loads[0].force[0] = 0.2 * bending;
  scene.loads[0].moment = {0.0, 0.0, 100.0};
  const std::unique_ptr<solve::LaneNewton> lanes(makes[0]());
  for (int lane = 0; lane < solve::kPathLanes; ++lane) {
    scene.material.youngs_modulus = 200e9 * (1.0 + 0.1 * lane);
    SolvedChain<Level<double>, false, law::ElasticSection<double>> solved(
        scene, material_values(scene.material), view);
    solved.go_to(1.0, 1);
    std::vector<std::size_t> shape;
    std::vector<double> numbers;
    chain::FieldWriter chain_writer{shape, numbers};
    chain::visit_chain(chain_writer, solved.build.chain);
    solved.joints->visit(chain_writer, [](auto& v, auto& law) { chain::visit_law(v, law); });
    if (lane == 0) lanes->take_shape(shape.data());
    lanes->take_chain(lane, numbers.data());
    numbers.clear();
    chain::visit_unknowns(chain_writer, solved.work.q);
    numbers.insert(numbers.end(),
                   {solved.work.moment_scale, solved.work.force_scale, solved.work.stepped});
    for (const History& history : solved.build.chain.histories) numbers.push_back(history.at(1.0));
    lanes->take_start(lane, numbers.data());
  }
  std::array<double, solve::kPathLanes> imbalance{};
  double iterations = 0.0;
  for (auto _ : state) {
    lanes->evaluate(imbalance.data());
    lanes->step();
    iterations += solve::kPathLanes;
  }
  for (const double left : imbalance) {
    if (!(left < 1e-10)) state.SkipWithError("no equilibrium");
  }
  count(state, iterations, segments);
}

const solve::LaneNewtonTable& newton_of(const benchmark::State& state) {
  const auto set = static_cast<InstructionSet>(state.range(1));
  return solve::lane_newton(resolved(set));
}
void planar_lanes(benchmark::State& state) {
  newton_lanes<chain::Planar>(state, {1}, newton_of(state).planar);
}
void spatial_lanes(benchmark::State& state) {
  newton_lanes<chain::Spatial>(state, {}, newton_of(state).spatial);
}
void sets(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"segments", "isa"});
  for (const int isa : {0, 1, 2, 3}) {
    if (has_instruction_set(static_cast<InstructionSet>(isa))) benchmark->Args({64, isa});
  }
}
BENCHMARK(planar_lanes)->Apply(sets);
BENCHMARK(spatial_lanes)->Apply(sets);

BENCHMARK(twist)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(planar)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(planar_elastic)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(spatial)->RangeMultiplier(4)->Range(16, 4096);
BENCHMARK(spatial_elastic)->RangeMultiplier(4)->Range(16, 4096);

/// How far the loads go: over the caps, all joints yield in all that they bend and twist about. A
/// spring beside each joint holds them then.
enum Reach { kUnyielded, kYielded };
constexpr double kSpring = 0.2;

/// A bar bent and twisted evenly, solved to and fro between two loads, by a law.
/// @param law_of  makes the law of a section's form
template <class Law, class L, class LawOf>
void bend_evenly(benchmark::State& state, const chain::View<L>& view, Reach reach,
                 const LawOf& law_of) {
  const auto segments = static_cast<int>(state.range(0));
  Scene scene = cantilever(segments, {});
  scene.section.height = 0.03;
  const auto values = material_values(scene.material);
  SolvedChain<L, false, Law> solved(scene, values, view, law_of, kSpring);
  const law::SectionForm& form = solved.layout.regions[0].form;
  chain::SegmentLoad<L> load;
  load.segment = solved.layout.size() - 1;
  load.history = solved.build.chain.histories.size();
  solved.build.chain.histories.push_back(History::ramp());
  const double fraction = reach == kYielded ? 1.5 : 0.3;
  for (std::size_t k = 0; k < L::kRotations; ++k) {
    const std::size_t axis = view.section_axes().rotation(k);
    load.moment[k] =
        fraction * form.modulus[axis] * law::uniaxial_material(form.axis[axis], values).yield;
  }
  solved.build.chain.loads.push_back(load);
  double iterations = 0.0;
  bool there = true;
  bool converged = true;
  for (auto _ : state) {
    there = !there;
    solved.work.time = there ? 1.0 : 0.95;
    const auto outcome = solve::equilibrate(solved.build.chain, *solved.joints, {}, solved.work);
    iterations += outcome.iterations + 1;
    converged = converged && outcome.converged;
  }
  if (!converged) state.SkipWithError("no equilibrium");
  count(state, iterations, segments);
}

MaterialValues<double> steel() { return material_values(cantilever(1, {}).material); }

template <class L>
void elastic(benchmark::State& state, const chain::View<L>& view) {
  using Law = law::ElasticSection<double>;
  bend_evenly<Law>(state, view, kUnyielded, [](const law::SectionForm& form) {
    return law::elastic_section(form, steel());
  });
}

template <class L>
void per_axis(benchmark::State& state, const chain::View<L>& view, Reach reach) {
  bend_evenly<law::PerAxisSection<double, Ideal>>(state, view, reach, [](const auto& form) {
    return law::per_axis_section<Ideal>(form, steel());
  });
}

template <class L>
void interaction(benchmark::State& state, const chain::View<L>& view, Reach reach) {
  Section section = cantilever(1, {}).section;
  section.height = 0.03;
  const auto surface =
      law::gauge_form(section, YieldModel::Interaction, YieldCap::FirstYield, Formulas::Mechanics);
  law::with_gauge<double>(surface, [&](const auto& gauge) {
    using Gauge = std::remove_cvref_t<decltype(gauge)>;
    bend_evenly<law::InteractionSection<double, Gauge, Ideal>>(
        state, view, reach, [&](const law::SectionForm& form) {
          return law::interaction_section<Ideal>(form, gauge, steel());
        });
  });
}

/// 20 layers; in space a grid of 20 along the height.
template <class L>
void fibre20(benchmark::State& state, const chain::View<L>& view, Reach reach) {
  Section section = cantilever(1, {}).section;
  section.height = 0.03;
  const auto plane = L::kRotations == 1 ? law::FibrePlane::AboutX : law::FibrePlane::Both;
  const auto layout = law::fibre_layout(section, section_properties(section, 0.3), plane, 20);
  if constexpr (L::kRotations == 1) {
    bend_evenly<law::FibreSection<double, Ideal>>(
        state, view, reach, [&](const law::SectionForm& form) {
          return law::fibre_section<Ideal>(layout, form, steel());
        });
  } else {
    bend_evenly<law::FibreGrid<double, Ideal>>(
        state, view, reach, [&](const law::SectionForm& form) {
          return law::fibre_grid<Ideal>(layout, form, steel());
        });
  }
  state.counters["fibres"] = static_cast<double>(layout.area.size());
}

const chain::View<chain::Planar<double>> kPlane{1};
const chain::View<chain::Spatial<double>> kSpace{};

void sizes(benchmark::internal::Benchmark* b) { b->Arg(64)->Arg(1024); }

BENCHMARK_CAPTURE(elastic, planar, kPlane)->Apply(sizes);
BENCHMARK_CAPTURE(per_axis, planar_unyielded, kPlane, kUnyielded)->Apply(sizes);
BENCHMARK_CAPTURE(per_axis, planar_yielded, kPlane, kYielded)->Apply(sizes);
BENCHMARK_CAPTURE(fibre20, planar_unyielded, kPlane, kUnyielded)->Apply(sizes);
BENCHMARK_CAPTURE(fibre20, planar_yielded, kPlane, kYielded)->Apply(sizes);
BENCHMARK_CAPTURE(elastic, spatial, kSpace)->Apply(sizes);
BENCHMARK_CAPTURE(per_axis, spatial_unyielded, kSpace, kUnyielded)->Apply(sizes);
BENCHMARK_CAPTURE(per_axis, spatial_yielded, kSpace, kYielded)->Apply(sizes);
BENCHMARK_CAPTURE(interaction, spatial_unyielded, kSpace, kUnyielded)->Apply(sizes);
BENCHMARK_CAPTURE(interaction, spatial_yielded, kSpace, kYielded)->Apply(sizes);
BENCHMARK_CAPTURE(fibre20, spatial_unyielded, kSpace, kUnyielded)->Apply(sizes);
BENCHMARK_CAPTURE(fibre20, spatial_yielded, kSpace, kYielded)->Apply(sizes);

}  // namespace
}  // namespace plastica
