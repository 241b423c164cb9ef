#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "tests/support/motion_scene.hpp"

namespace plastica {
namespace {

using testing::add_probe;
using testing::breaking_scene;
using testing::drift_of;
using testing::flying_scene;
using testing::last_energy;
using testing::motion_options;
using testing::struck_scene;

TEST(MotionBreak, CutsTheRootOfAStruckCantileverWhichFliesOff) {
  Scene scene = breaking_scene(16);
  add_probe(scene, ProbeQuantity::ReactionMoment, Place::start(), Component::X);
  const Response response = simulate(scene, motion_options(Scheme::EnergyMomentum, 1e-4, 400));
  EXPECT_EQ(response.status, Status::Broken);
  ASSERT_EQ(response.chain.events.size(), 1U);
  const ChainBreak& event = response.chain.events.front();
  ASSERT_EQ(event.joints.size(), 1U);
  const BrokenJoint& joint = event.joints.front();
  EXPECT_EQ(joint.joint, 0);
  EXPECT_EQ(joint.cause, BreakCause::BendingX);
  EXPECT_TRUE(joint.cut);
  EXPECT_GE(joint.strain, 0.05);
  EXPECT_GT(std::fabs(joint.moment[0]), 300.0);
  EXPECT_GT(joint.dissipation, 10.0);
  EXPECT_EQ(event.fragments, (std::vector<Fragment>{{0, 15}}));
  EXPECT_GT(last_energy(response).fracture, 0.0);
  const auto& moment = response.probes[0];
  const auto after = static_cast<std::size_t>(event.time / 1e-4) + 2;
  EXPECT_NE(moment[after - 4], 0.0);
  EXPECT_EQ(moment[after], 0.0);
  // The joint keeps what it broke with.
  EXPECT_NEAR(response.permanent_strain, joint.strain, 1e-12);
}

TEST(MotionBreak, LeavesAllWholeWithoutALimit) {
  const Response response =
      simulate(struck_scene(16, 30.0), motion_options(Scheme::EnergyMomentum, 1e-4, 200));
  EXPECT_EQ(response.status, Status::Completed);
  EXPECT_TRUE(response.chain.events.empty());
}

TEST(MotionBreak, RecordsEachJointOnceWhereNothingIsToBeCut) {
  Scene scene = breaking_scene(16);
  scene.on_break = BreakPolicy::RecordOnly;
  const Response response = simulate(scene, motion_options(Scheme::EnergyMomentum, 1e-4, 300));
  ASSERT_FALSE(response.chain.events.empty());
  std::vector<int> reported;
  for (const ChainBreak& event : response.chain.events) {
    EXPECT_EQ(event.fragments.size(), 1U);
    for (const BrokenJoint& joint : event.joints) {
      EXPECT_FALSE(joint.cut);
      EXPECT_EQ(std::count(reported.begin(), reported.end(), joint.joint), 0);
      reported.push_back(joint.joint);
    }
  }
  EXPECT_EQ(last_energy(response).fracture, 0.0);
}

/// Pure bending by a moment at the end, without mass to speak of at the joints: all break at once.
Scene evenly_bent_scene(int segments) {
  Scene scene = testing::cantilever_scene(segments);
  scene.yield_model = YieldModel::Interaction;
  scene.material.hardening.law = HardeningLaw::Linear;
  scene.material.hardening.tangent_modulus = 2e9;
  scene.material.break_strain = 1e-4;
  scene.material.density = 1e-3;
  Support end{.at = Place::end(), .kind = SupportKind::Guide};
  end.hold = HeldFreedoms{false, false, false, true, false, false};
  end.rotation = {-0.4, 0.0, 0.0};
  end.history = {{0.0, 0.02}, {0.0, 1.0}};
  scene.supports.push_back(end);
  return scene;
}

TEST(MotionBreak, CutsAllJointsThatBreakInAStepOrTheWorstOfThem) {
  Scene scene = evenly_bent_scene(6);
  // One long step of the scheme that damps most is nearly at rest.
  const SolverOptions options = motion_options(Scheme::LinearlyImplicitEuler, 2e-2, 1);
  const Response all = simulate(scene, options);
  ASSERT_FALSE(all.chain.events.empty());
  std::size_t cut = 0;
  for (const ChainBreak& event : all.chain.events) cut += event.joints.size();
  EXPECT_EQ(all.chain.events.back().fragments.size(), 6U);
  EXPECT_EQ(cut, 7U) << "both half joints and those between";
  for (const double position : all.chain.position) EXPECT_TRUE(std::isfinite(position));

  scene.on_break = BreakPolicy::CutWorst;
  const Response worst = simulate(scene, options);
  for (const ChainBreak& event : worst.chain.events) {
    EXPECT_EQ(std::count_if(event.joints.begin(), event.joints.end(),
                            [](const BrokenJoint& joint) { return joint.cut; }),
              1);
  }
}

TEST(MotionBreak, KeepsTheLastShapeOfARunThatIsStopped) {
  SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-4, 100);
  options.frames = 4;
  const Model model = prepare(breaking_scene(8), options);
  Workspace workspace = make_workspace(model);
  Response response = make_response(model);
  workspace.on_progress = [](double time) { return time < 3.05e-3; };
  run(model, {}, workspace, response);
  EXPECT_EQ(response.status, Status::Interrupted);
  EXPECT_EQ(response.samples, 31U);
  EXPECT_EQ(response.chain.frame_sample, (std::vector<std::size_t>{0, 25, 30, 75, 100}));
  workspace.on_progress = nullptr;
  run(model, {}, workspace, response);
  EXPECT_EQ(response.chain.frame_sample, (std::vector<std::size_t>{0, 25, 50, 75, 100}));
}

TEST(MotionBreak, RefusesJointsThatAListenerAdds) {
  for (const int joint : {-1, 3, 100000}) {
    EXPECT_THROW(simulate(breaking_scene(16), motion_options(Scheme::EnergyMomentum, 1e-4, 200),
                          [&](ChainBreak& event) {
                            BrokenJoint more;
                            more.joint = joint;
                            more.cut = true;
                            event.joints.push_back(more);
                          }),
                 std::invalid_argument);
  }
}

TEST(MotionBreak, AsksTheListenerWhatToCut) {
  int asked = 0;
  const Response response =
      simulate(breaking_scene(16), motion_options(Scheme::EnergyMomentum, 1e-4, 200),
               [&](ChainBreak& event) {
                 ++asked;
                 for (BrokenJoint& joint : event.joints) joint.cut = false;
               });
  EXPECT_GT(asked, 0);
  EXPECT_EQ(static_cast<std::size_t>(asked), response.chain.events.size());
  EXPECT_EQ(last_energy(response).fracture, 0.0);
}

TEST(MotionBreak, CutsWhereTheSceneSaysAndKeepsMomentum) {
  for (const bool in_space : {false, true}) {
    Scene scene = flying_scene(12, in_space);
    scene.cuts = {{{0.5, {}}, 0.02}, {{0.25, {}}, 0.02}, {{0.75, {}}, 0.03}};
    add_probe(scene, ProbeQuantity::Momentum, {}, Component::Y);
    add_probe(scene, ProbeQuantity::AngularMomentum, {}, Component::X);
    const SolverOptions options = motion_options(Scheme::EnergyMomentum, 1e-3, 100);
    const Response response = simulate(scene, options);
    ASSERT_EQ(response.chain.events.size(), 2U);
    EXPECT_EQ(response.chain.events[0].time, 0.02);
    ASSERT_EQ(response.chain.events[0].joints.size(), 2U);
    EXPECT_EQ(response.chain.events[0].joints[0].joint, 3);
    EXPECT_EQ(response.chain.events[0].joints[0].cause, BreakCause::Cut);
    EXPECT_EQ(response.chain.events[0].joints[1].joint, 6);
    EXPECT_EQ(response.chain.events[1].fragments,
              (std::vector<Fragment>{{0, 2}, {3, 5}, {6, 8}, {9, 11}}));
    EXPECT_LT(drift_of(response, 0), 1e-10);
    EXPECT_LT(drift_of(response, 1), 1e-10);
    EXPECT_LT(response.energy_balance_error, 1e-8);
  }
}

}  // namespace
}  // namespace plastica
