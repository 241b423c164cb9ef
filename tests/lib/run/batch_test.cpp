#include "plastica/run/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "tests/support/scene.hpp"

namespace plastica {
namespace {

using testing::coupon_scene;

BatchOptions with_threads(int threads) {
  BatchOptions options;
  options.threads = threads;
  return options;
}

std::vector<BatchCase> make_cases(std::size_t count) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    Scene scene = coupon_scene(static_cast<Deformation>(i % 3), {0.001 * x, 0.02, -0.01, 0.03});
    scene.material.yield_stress = 100e6 + 7e6 * x;
    scene.material.hardening = {static_cast<HardeningLaw>(i / 3 % 3),
                                2e9,
                                0.3,
                                80e6,
                                12.0,
                                {20e9, 1e9, 0.0},
                                {300.0, 0.0, 0.0}};
    if (i % 4 == 0) scene.material.break_strain = 0.01;
    cases.push_back({"case-" + std::to_string(i), scene, {}});
  }
  return cases;
}

void expect_same(const BatchRow& a, const BatchRow& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.response.status, b.response.status);
  EXPECT_EQ(a.response.probes, b.response.probes);
  EXPECT_EQ(a.response.permanent_strain, b.response.permanent_strain);
  ASSERT_EQ(a.response.event.has_value(), b.response.event.has_value());
  if (a.response.event) {
    EXPECT_EQ(a.response.event->strain, b.response.event->strain);
    EXPECT_EQ(a.response.event->dissipation, b.response.event->dissipation);
  }
}

TEST(RunBatch, GivesTheSameBitsForEveryNumberOfThreads) {
  const std::vector<BatchCase> cases = make_cases(40);
  const std::vector<BatchRow> expected = run_batch(cases, with_threads(1));
  for (const int threads : {2, 3, 8}) {
    const std::vector<BatchRow> rows = run_batch(cases, with_threads(threads));
    for (std::size_t i = 0; i < cases.size(); ++i) expect_same(rows[i], expected[i]);
  }
}

TEST(RunBatch, GivesTheSameBitsInEveryOrder) {
  const std::vector<BatchCase> cases = make_cases(40);
  const std::vector<BatchRow> expected = run_batch(cases, with_threads(2));
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  std::vector<BatchCase> shuffled;
  for (const std::size_t i : order) shuffled.push_back(cases[i]);
  const std::vector<BatchRow> rows = run_batch(shuffled, with_threads(2));
  for (std::size_t i = 0; i < order.size(); ++i) expect_same(rows[i], expected[order[i]]);
}

TEST(RunBatch, MakesABadCaseARowWithItsReasonAndGoesOn) {
  std::vector<BatchCase> cases = make_cases(9);
  cases[4].scene.material.yield_stress = -1.0;
  const std::vector<BatchRow> rows = run_batch(cases, with_threads(2));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].id, cases[i].id);
    if (i == 4) continue;
    EXPECT_TRUE(usable(rows[i].response.status));
    EXPECT_EQ(rows[i].reason, "");
  }
  EXPECT_EQ(rows[4].response.status, Status::Rejected);
  EXPECT_NE(rows[4].reason.find("material.yield_stress = -1: "), std::string::npos);
}

TEST(RunBatch, LeavesCasesNotBegunWhenItIsStopped) {
  const std::vector<BatchCase> cases = make_cases(50);
  std::atomic<bool> stop{false};
  BatchOptions options = with_threads(2);
  options.stop = &stop;
  options.progress = [&](std::size_t finished) {
    if (finished == 5) stop = true;
  };
  const std::vector<BatchRow> rows = run_batch(cases, options);
  const auto begun = std::count_if(rows.begin(), rows.end(), [](const BatchRow& row) {
    return row.response.status != Status::NotRun;
  });
  EXPECT_GE(begun, 5);
  EXPECT_LE(begun, 7);
  EXPECT_EQ(rows.back().response.status, Status::NotRun);
  EXPECT_EQ(rows.back().id, "case-49");
}

TEST(RunBatch, CountsEachCaseOnce) {
  const std::vector<BatchCase> cases = make_cases(30);
  std::vector<std::size_t> counts;
  BatchOptions options = with_threads(3);
  options.progress = [&](std::size_t finished) { counts.push_back(finished); };
  run_batch(cases, options);
  ASSERT_EQ(counts.size(), cases.size());
  for (std::size_t i = 0; i < counts.size(); ++i) EXPECT_EQ(counts[i], i + 1);
}

TEST(RunBatchOfOneModel, GivesTheBitsOfLoneRunsForEveryNumberOfThreads) {
  const std::vector<std::string> parameters{"yield_stress", "youngs_modulus"};
  const Model model =
      prepare(coupon_scene(Deformation::Tension, {0.001, 0.02, -0.01}), {}, parameters);
  std::vector<double> values;
  for (int i = 0; i < 30; ++i) {
    values.push_back(i == 11 ? -1.0 : 100e6 + 5e6 * i);
    values.push_back(70e9 + 4e9 * i);
  }
  for (const int threads : {1, 2, 3, 8}) {
    const std::vector<Response> responses = run_batch(model, values, 30, with_threads(threads));
    for (std::size_t i = 0; i < 30; ++i) {
      Response lone = make_response(model);
      Workspace workspace = make_workspace(model);
      run(model, std::span(values).subspan(2 * i, 2), workspace, lone);
      EXPECT_EQ(responses[i].probes, lone.probes);
      EXPECT_EQ(responses[i].status, i == 11 ? Status::InvalidParameter : Status::Completed);
    }
  }
}

TEST(RunBatchOfOneModel, RefusesAWrongNumberOfValues) {
  const std::vector<std::string> parameters{"yield_stress"};
  const Model model = prepare(coupon_scene(Deformation::Tension, {0.001}), {}, parameters);
  const std::vector<double> values(3, 1e8);
  EXPECT_THROW(run_batch(model, values, 2), InputError);
}

}  // namespace
}  // namespace plastica
