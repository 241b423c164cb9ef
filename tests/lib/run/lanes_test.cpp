#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"

/// Batches whose cases are stepped side by side.
namespace plastica {
namespace {

using testing::add_probe;

/// Beams of three shapes, some that yield, some that need shorter steps, some at rest, one of them
/// rejected; each with numbers of its own.
std::vector<BatchCase> mixed_cases(std::size_t count) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    Scene scene = testing::struck_scene(4 + static_cast<int>(i % 3), 5.0 + x,
                                        i % 4 == 0 ? YieldModel::PerAxis : YieldModel::Elastic);
    scene.material.yield_stress = 200e6 + 1e6 * x;
    scene.section.height = 0.02 + 1e-4 * x;
    if (i % 7 == 3) scene.initial_motions[0].velocity[1] = -400.0;  // shorter steps
    add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
    add_probe(scene, ProbeQuantity::Moment, Place::start(), Component::X);
    SolverOptions options = testing::motion_options(Scheme::ArticulatedMidpoint, 1e-4, 5);
    options.duration = 2e-3;
    if (i % 5 == 2) options.scheme = Scheme::ArticulatedEuler;
    if (i % 11 == 4) options.scheme = Scheme::LinearlyImplicitMidpoint;
    if (i % 13 == 6) scene.material.youngs_modulus = -1.0;
    cases.push_back({"case-" + std::to_string(i), scene, options});
  }
  return cases;
}

void expect_same(const BatchRow& a, const BatchRow& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.response.status, b.response.status);
  EXPECT_EQ(a.response.probes, b.response.probes) << a.id;
  EXPECT_EQ(a.response.chain.moment, b.response.chain.moment) << a.id;
  EXPECT_EQ(a.response.counters.cutbacks, b.response.counters.cutbacks) << a.id;
}

TEST(Lanes, GiveACaseTheSameBitsInWhateverCompany) {
  const std::vector<BatchCase> cases = mixed_cases(60);
  std::vector<BatchRow> alone;
  int cut = 0;
  for (const BatchCase& one : cases) {
    alone.push_back(run_case(one));
    cut += alone.back().response.counters.cutbacks > 0 ? 1 : 0;
  }
  EXPECT_GT(cut, 2);
  std::mt19937 random(5);
  for (const int threads : {1, 2, 5}) {
    std::vector<std::size_t> order(cases.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    std::vector<BatchCase> shuffled;
    for (const std::size_t i : order) shuffled.push_back(cases[i]);
    BatchOptions options;
    options.threads = threads;
    const std::vector<BatchRow> rows = run_batch(shuffled, options);
    for (std::size_t k = 0; k < order.size(); ++k) expect_same(rows[k], alone[order[k]]);
  }
}

TEST(Lanes, TellOfEveryCaseOnce) {
  const std::vector<BatchCase> cases = mixed_cases(21);
  std::vector<int> taken(cases.size(), 0);
  std::size_t finished = 0;
  BatchOptions options;
  options.progress = [&](std::size_t so_far) { finished = std::max(finished, so_far); };
  run_batch(
      cases.size(), [&](std::size_t i) { return cases[i]; },
      [&](std::size_t i, BatchRow&& row) {
        ++taken[i];
        EXPECT_EQ(row.id, cases[i].id);
        EXPECT_NE(row.response.status, Status::NotRun);
      },
      options);
  EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), 21);
  EXPECT_EQ(finished, 21U);
}

TEST(Lanes, RunOneModelWithManyValues) {
  BatchCase one = mixed_cases(1)[0];
  one.scene.initial_motions[0].velocity[1] = -30.0;
  const std::vector<std::string> parameters{"material.yield_stress"};
  const Model model = prepare(one.scene, one.options, parameters);
  std::vector<double> values;
  for (int i = 0; i < 35; ++i) values.push_back(i == 4 ? -1.0 : 150e6 + 6e6 * i);
  // In one thread, so that its lanes are used again.
  const auto together = run_batch(model, values, values.size(), {.threads = 1});
  for (std::size_t i = 0; i < values.size(); ++i) {
    Response alone = make_response(model);
    Workspace workspace = make_workspace(model);
    run(model, {&values[i], 1}, workspace, alone);
    EXPECT_EQ(together[i].status, alone.status);
    if (alone.status == Status::Completed) {
      EXPECT_EQ(together[i].probes, alone.probes) << i;
    }
  }
  EXPECT_EQ(together[4].status, Status::InvalidParameter);
  EXPECT_NE(together[0].probes, together[34].probes);
}

TEST(Lanes, AgreeBetweenInstructionSets) {
  BatchCase one = mixed_cases(2)[1];
  one.options.isa = InstructionSet::Baseline;
  const BatchRow base = run_case(one);
  for (const InstructionSet level : {InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (!has_instruction_set(level)) continue;
    one.options.isa = level;
    const BatchRow row = run_case(one);
    for (std::size_t i = 0; i < row.response.samples; ++i) {
      EXPECT_NEAR(row.response.probes[0][i], base.response.probes[0][i], 1e-11);
    }
  }
}

}  // namespace
}  // namespace plastica
