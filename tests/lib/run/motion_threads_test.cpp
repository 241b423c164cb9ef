#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica {
namespace {

using testing::flying_scene;
using testing::motion_options;
using testing::struck_scene;

/// Of every level, scheme and yield model, some breaking, one bad, one at rest.
std::vector<BatchCase> mixed_cases() {
  std::vector<BatchCase> cases;
  const auto add = [&](Scene scene, SolverOptions options) {
    options.fibres = 8;
    cases.push_back({std::to_string(cases.size()), std::move(scene), options, {}});
  };
  for (int k = 0; k < 12; ++k) {
    const auto scheme = static_cast<Scheme>(k % 4);
    Scene scene =
        struck_scene(6 + k % 3, 20.0 + k, k % 3 == 0 ? YieldModel::Fibre : YieldModel::Interaction);
    scene.material.break_strain = 0.02;
    if (k % 4 == 1) scene.initial_motions[0].velocity[0] = 10.0;
    add(scene, motion_options(scheme, 2e-4, 20));
    add(flying_scene(5, k % 2 == 0), motion_options(scheme, 1e-3, 20));
  }
  Scene twisted = testing::cantilever_scene(6);
  twisted.initial_motions.push_back({.from = {0.5, {}}, .spin = {0.0, 0.0, 20.0}});
  add(twisted, motion_options(Scheme::EnergyMomentum, 1e-4, 20));
  Scene bad = struck_scene(6, 10.0);
  bad.material.density = -1.0;
  add(bad, motion_options(Scheme::EnergyMomentum, 1e-4, 20));
  Scene still = testing::cantilever_scene(6);
  Load load;
  load.force = {0.0, -10.0, 0.0};
  still.loads.push_back(load);
  add(still, {});
  return cases;
}

void expect_same_bits(const Response& a, const Response& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.probes, b.probes);
  EXPECT_EQ(a.chain.position, b.chain.position);
  EXPECT_EQ(a.chain.plastic_strain, b.chain.plastic_strain);
  ASSERT_EQ(a.chain.events.size(), b.chain.events.size());
  for (std::size_t e = 0; e < a.chain.events.size(); ++e) {
    EXPECT_EQ(a.chain.events[e].time, b.chain.events[e].time);
    EXPECT_EQ(a.chain.events[e].fragments, b.chain.events[e].fragments);
    ASSERT_EQ(a.chain.events[e].joints.size(), b.chain.events[e].joints.size());
    for (std::size_t j = 0; j < a.chain.events[e].joints.size(); ++j) {
      EXPECT_EQ(a.chain.events[e].joints[j].joint, b.chain.events[e].joints[j].joint);
    }
  }
  for (std::size_t i = 0; i < a.samples; ++i) {
    EXPECT_EQ(a.chain.energy[i].kinetic, b.chain.energy[i].kinetic);
    EXPECT_EQ(a.chain.energy[i].residual, b.chain.energy[i].residual);
  }
}

TEST(MotionThreads, GivesTheSameBitsForEveryNumberOfThreads) {
  const std::vector<BatchCase> cases = mixed_cases();
  const auto alone = run_batch(cases, {.threads = 1});
  for (const int threads : {2, 5, 8}) {
    if (testing::kSanitized && threads != 5) continue;
    const auto rows = run_batch(cases, {.threads = threads});
    for (std::size_t k = 0; k < cases.size(); ++k) {
      SCOPED_TRACE(cases[k].id);
      expect_same_bits(alone[k].response, rows[k].response);
    }
  }
  EXPECT_EQ(alone[25].response.status, Status::Rejected);
  EXPECT_EQ(alone[26].response.status, Status::Completed);
}

TEST(MotionThreads, AsksEachRunsOwnListener) {
  std::vector<BatchCase> cases = mixed_cases();
  std::vector<std::size_t> heard(cases.size(), 0);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    cases[k].on_break = [&heard, k](ChainBreak& event) {
      ++heard[k];
      for (BrokenJoint& joint : event.joints) joint.cut = joint.joint % 2 == 0;
    };
  }
  std::vector<Response> responses(cases.size());
  std::vector<std::thread> threads;
  for (std::size_t first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (std::size_t k = first; k < cases.size(); k += 4) {
        if (k == 25) continue;  // the bad one
        responses[k] = simulate(cases[k].scene, cases[k].options, cases[k].on_break);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::size_t all = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    all += heard[k];
    if (k < 24) {
      EXPECT_EQ(heard[k], responses[k].chain.events.size()) << k;
    }
  }
  EXPECT_GT(all, 0U);
}

TEST(MotionThreads, RemembersNothingOfTheRunBeforeInAWorkspace) {
  Scene scene = testing::cantilever_scene(6);
  scene.supports[0].translation = {0.0, 0.01, 0.0};
  Support end{.at = Place::end(), .kind = SupportKind::Guide};
  end.hold = HeldFreedoms{false, false, false, true, false, false};
  end.rotation = {-0.1, 0.0, 0.0};
  scene.supports.push_back(end);
  Support pillar{.at = Place{0.5, {}}, .kind = SupportKind::Pillar};
  pillar.gap = 0.001;
  scene.supports.push_back(pillar);
  scene.gravity = {0.0, -9.81, 0.0};
  for (int scheme = 0; scheme < 4; ++scheme) {
    SolverOptions options = motion_options(static_cast<Scheme>(scheme), 1e-3, 50);
    options.damping = Damping::Stiffness;
    options.damping_time = 1e-3;
    const Model model = prepare(scene, options);
    Workspace workspace = make_workspace(model);
    Response first = make_response(model);
    Response second = make_response(model);
    run(model, {}, workspace, first);
    run(model, {}, workspace, second);
    ASSERT_EQ(first.status, Status::Completed);
    expect_same_bits(first, second);
  }
}

TEST(MotionThreads, SharesOneModelAmongWorkspaces) {
  const Model model =
      prepare(struck_scene(8, 20.0), motion_options(Scheme::EnergyMomentum, 1e-4, 50));
  std::vector<Response> responses(4);
  std::vector<std::thread> threads;
  for (Response& response : responses) {
    threads.emplace_back([&] {
      response = make_response(model);
      Workspace workspace = make_workspace(model);
      run(model, {}, workspace, response);
      run(model, {}, workspace, response);  // once more in the same workspace
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Response& response : responses) expect_same_bits(responses[0], response);
}

}  // namespace
}  // namespace plastica
