#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/run/lane_program.hpp"
#include "tests/support/lanes_like_alone.hpp"
#include "tests/support/motion_scene.hpp"
#include "tests/support/sanitized.hpp"

/// Batches of motions of the general schemes, which are stepped side by side: each has the bits
/// that it has alone, whatever the others do.
namespace plastica {
namespace {

using testing::bits_of;
using testing::expect_bits_of_alone;

constexpr Scheme kSchemes[] = {Scheme::LinearlyImplicitEuler, Scheme::LinearlyImplicitMidpoint,
                               Scheme::GeneralizedAlpha, Scheme::EnergyMomentum};

void probe_motion(Scene& scene) {
  testing::add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
  testing::add_probe(scene, ProbeQuantity::Velocity, Place::end(), Component::Size);
  testing::add_probe(scene, ProbeQuantity::Moment, {0.5, {}}, Component::X);
  testing::add_probe(scene, ProbeQuantity::Reaction, Place::start(), Component::Y);
}

/// Numbers that differ from case to case.
void differ(Scene& scene, std::size_t i) {
  const double x = static_cast<double>(i);
  scene.material.youngs_modulus *= 1.0 + 0.03 * x;
  scene.material.yield_stress *= 1.0 + 0.02 * x;
  scene.material.density *= 1.0 + 0.01 * x;
  scene.section.height *= 1.0 + 0.005 * x;
  probe_motion(scene);
  if (scene.supports.empty()) scene.probes.pop_back();
}

/// A cantilever that is struck, with its weight and a follower.
Scene struck(std::size_t i, YieldModel model, bool in_space) {
  Scene scene = testing::struck_scene(6, 12.0 + static_cast<double>(i), model);
  if (in_space) {
    InitialMotion turn;
    turn.from = {0.5, {}};
    turn.velocity = {4.0, 0.0, 0.0};
    turn.spin = {0.0, 0.0, 6.0};
    scene.initial_motions.push_back(turn);
  }
  Load push;
  push.at = Place::end();
  push.force = {0.0, -40.0, 5.0};
  push.follows = true;
  push.history = History::sine(4e-3, 2.0);
  scene.loads = {push};
  differ(scene, i);
  return scene;
}

/// Both ends held, one of them moved and stopped, with a spring and a turned clamp.
Scene moved_and_stopped(std::size_t i) {
  Scene scene = testing::struck_scene(6, 5.0, YieldModel::PerAxis);
  Support hand{.at = Place::end(), .kind = SupportKind::Clamp};
  hand.hold = HeldFreedoms{false, true, false, true, false, false};
  hand.translation = {0.0, 0.004 + 0.001 * static_cast<double>(i), 0.0};
  hand.rotation = {0.02, 0.0, 0.0};
  hand.history = {{0.0, 0.0015, 0.005}, {0.0, 1.0, 1.0}};
  scene.supports.push_back(hand);
  scene.supports.push_back(
      {.at = {0.6, {}}, .kind = SupportKind::Elastic, .stiffness = {0.0, 2e4, 0.0}});
  differ(scene, i);
  return scene;
}

BatchCase motion_case(std::size_t i, Scene scene, Scheme scheme, InstructionSet isa) {
  constexpr int kSteps = testing::kSanitized ? 6 : 12;
  BatchCase one{std::to_string(i), std::move(scene), testing::motion_options(scheme, 5e-4, kSteps)};
  one.options.isa = isa;
  one.options.frames = 0;
  return one;
}

/// Eleven cases: more than lanes, so that some wait for another group.
template <class MakeScene>
std::vector<BatchCase> eleven_motions(const MakeScene& make, Scheme scheme, InstructionSet isa) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < 11; ++i) cases.push_back(motion_case(i, make(i), scheme, isa));
  // Else both sides of a comparison would run alone.
  const Model first = prepare(cases[0].scene, cases[0].options);
  for (const BatchCase& one : cases) {
    EXPECT_TRUE(same_lanes(*first.chain, *prepare(one.scene, one.options).chain)) << one.id;
  }
  return cases;
}

template <class MakeScene>
void expect_motions_like_alone(const MakeScene& make) {
  for (const InstructionSet isa : testing::instruction_sets()) {
    for (const Scheme scheme : kSchemes) expect_bits_of_alone(eleven_motions(make, scheme, isa));
  }
}

TEST(MotionLanes, HaveTheBitsOfLoneElasticBeams) {
  expect_motions_like_alone([](std::size_t i) { return struck(i, YieldModel::Elastic, false); });
}

/// How many of eight cases do not ride to their end.
std::size_t left_of(const std::vector<BatchCase>& cases) {
  std::vector<Model> models;
  std::vector<Workspace> hooks(8);
  std::vector<Response> responses(8);
  std::vector<LaneCase> lanes;
  for (std::size_t i = 0; i < 8; ++i) {
    models.push_back(prepare(cases[i].scene, cases[i].options));
    responses[i] = make_response(models[i]);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    lanes.push_back({models[i].chain.get(), &models[i].material, &hooks[i], &responses[i]});
  }
  const auto program = make_lane_program(*models[0].chain);
  program->run(lanes);
  return program->left();
}

/// Else bits would be compared of beams that have all run alone.
TEST(MotionLanes, RideToTheirEnd) {
  for (const Scheme scheme : kSchemes) {
    for (const bool in_space : {false, true}) {
      EXPECT_EQ(left_of(eleven_motions(
                    [&](std::size_t i) { return struck(i, YieldModel::PerAxis, in_space); }, scheme,
                    InstructionSet::Auto)),
                0U);
    }
    EXPECT_EQ(left_of(eleven_motions(moved_and_stopped, scheme, InstructionSet::Auto)), 0U);
  }
}

/// Where joints ring faster than the steps, what velocities foretell leads nowhere in some steps.
TEST(MotionLanes, SeekOnceMoreFromRest) {
  std::vector<BatchCase> cases = eleven_motions(
      [](std::size_t i) {
        Scene scene =
            testing::struck_scene(24, 15.0 + 0.1 * static_cast<double>(i), YieldModel::PerAxis);
        differ(scene, i);
        return scene;
      },
      Scheme::LinearlyImplicitMidpoint, InstructionSet::Auto);
  for (BatchCase& one : cases) {
    one.options.time_step = 1e-4;
    one.options.duration = 4e-3;
  }
  EXPECT_EQ(left_of(cases), 0U);
  const Response one = simulate(cases[3].scene, cases[3].options);
  EXPECT_GT(one.counters.iterations, 2 * one.counters.steps);
  expect_bits_of_alone(cases);
}

TEST(MotionLanes, HaveTheBitsOfLoneElasticBeamsInSpace) {
  expect_motions_like_alone([](std::size_t i) { return struck(i, YieldModel::Elastic, true); });
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsThatYield) {
  expect_motions_like_alone([](std::size_t i) { return struck(i, YieldModel::PerAxis, false); });
  const BatchCase one = motion_case(3, struck(3, YieldModel::PerAxis, false),
                                    Scheme::GeneralizedAlpha, InstructionSet::Auto);
  EXPECT_GT(simulate(one.scene, one.options).permanent_strain, 1e-4);
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsThatHardenInSpace) {
  expect_motions_like_alone([](std::size_t i) {
    Scene scene = struck(i, YieldModel::PerAxis, true);
    scene.material.hardening.law = HardeningLaw::Linear;
    scene.material.hardening.tangent_modulus = 20e9;
    scene.material.hardening.kinematic_fraction = 0.3;
    return scene;
  });
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsThatHardenAlongCurves) {
  for (const bool in_space : {false, true}) {
    expect_motions_like_alone([&](std::size_t i) {
      Scene scene = struck(i, YieldModel::PerAxis, in_space);
      Hardening& hardening = scene.material.hardening;
      hardening.law = in_space ? HardeningLaw::Multilinear : HardeningLaw::VoceChaboche;
      if (in_space) {
        hardening.plastic_strain = {1e-3, 5e-3};
        hardening.flow_stress = {1.1 * scene.material.yield_stress,
                                 1.3 * scene.material.yield_stress};
        return scene;
      }
      hardening.saturation_stress = 60e6;
      hardening.saturation_rate = 120.0 + static_cast<double>(i);
      hardening.backstress_modulus = {30e9, 8e9, 0.0};
      hardening.backstress_rate = {600.0, 90.0, 0.0};
      return scene;
    });
  }
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsThatSupportsMoveAndStop) {
  expect_motions_like_alone(moved_and_stopped);
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsInFlight) {
  for (const bool in_space : {false, true}) {
    expect_motions_like_alone([&](std::size_t i) {
      Scene scene = testing::flying_scene(5, in_space);
      scene.initial_motions[0].spin[0] += 0.3 * static_cast<double>(i);
      differ(scene, i);
      return scene;
    });
  }
}

TEST(MotionLanes, HaveTheBitsOfLoneBeamsThatAreDamped) {
  for (const Damping damping : {Damping::Stiffness, Damping::Relaxation}) {
    for (const Scheme scheme : kSchemes) {
      std::vector<BatchCase> cases =
          eleven_motions([](std::size_t i) { return struck(i, YieldModel::PerAxis, true); }, scheme,
                         InstructionSet::Auto);
      for (BatchCase& one : cases) {
        one.options.damping = damping;
        one.options.damping_time = 1e-4;
      }
      expect_bits_of_alone(cases);
    }
  }
}

/// A clamp that turns has no corner, one that moves as well has.
TEST(MotionLanes, FitVelocitiesOfThoseAloneWhoseSupportsMove) {
  for (const Scheme scheme : kSchemes) {
    std::vector<BatchCase> cases;
    for (std::size_t i = 0; i < 8; ++i) {
      Scene scene = moved_and_stopped(i);
      Support& hand = scene.supports[1];
      hand.hold = HeldFreedoms{true, true, false, true, true, true};
      if (i % 2 == 0) hand.translation = {};
      cases.push_back(motion_case(i, std::move(scene), scheme, InstructionSet::Auto));
    }
    expect_bits_of_alone(cases);
    EXPECT_EQ(left_of(cases), 4U);
  }
}

/// Steps that fail, joints that break, supports that hold twice: those leave, the others stay.
TEST(MotionLanes, LeaveTheOthersAloneWhenOneLeaves) {
  for (const Scheme scheme : kSchemes) {
    std::vector<BatchCase> cases =
        eleven_motions([](std::size_t i) { return struck(i, YieldModel::PerAxis, false); }, scheme,
                       InstructionSet::Auto);
    for (BatchCase& one : cases) {
      one.options.time_step = 1e-4;
      one.options.duration = 12e-4;
      one.options.smallest_step = 0.5;
    }
    cases[2].scene.initial_motions[0].velocity[1] = -900.0;
    cases[5].scene.material.break_strain = 1e-3;
    cases[7].scene.material.break_strain = 1e-3;
    cases[7].scene.on_break = BreakPolicy::RecordOnly;
    cases[8].scene.loads[0].force[1] = 1e13;
    const std::vector<BatchRow> rows = run_batch(cases, {.threads = 1});
    EXPECT_GT(rows[2].response.counters.cutbacks, 0);
    EXPECT_EQ(rows[5].response.status, Status::Broken);
    EXPECT_NE(rows[8].response.status, Status::Completed);
    EXPECT_EQ(rows[4].response.status, Status::Completed);
    expect_bits_of_alone(cases);
    cases.resize(8);
    cases.erase(cases.begin() + 2);
    cases.push_back(cases[0]);
    EXPECT_EQ(left_of(cases), 2U);  // those that break
  }
}

TEST(MotionLanes, TakeShapesApartInWhateverOrder) {
  std::vector<BatchCase> cases;
  for (std::size_t i = 0; i < (testing::kSanitized ? 24 : 60); ++i) {
    const Scheme scheme = kSchemes[i / 4 % 4];
    Scene scene = i % 4 == 0   ? moved_and_stopped(i)
                  : i % 4 == 3 ? struck(i, YieldModel::PerAxis, true)
                               : struck(i, YieldModel::PerAxis, false);
    if (i % 8 == 1) scene.loads[0].at = {0.4, {}};
    cases.push_back(motion_case(i, std::move(scene), scheme, InstructionSet::Auto));
  }
  for (const int threads : {1, 3}) {
    std::reverse(cases.begin(), cases.end());
    expect_bits_of_alone(cases, threads);
  }
}

TEST(MotionLanes, RunOneModelWithManyValues) {
  const Scene scene = struck(0, YieldModel::PerAxis, false);
  const SolverOptions options = testing::motion_options(Scheme::EnergyMomentum, 5e-4, 12);
  const std::vector<std::string> parameters{"material.yield_stress"};
  const Model model = prepare(scene, options, parameters);
  std::vector<double> values;
  for (std::size_t i = 0; i < 13; ++i) values.push_back(200e6 + 1e7 * static_cast<double>(i));
  values[4] = -1.0;
  const std::vector<Response> together = run_batch(model, values, values.size());
  Workspace workspace = make_workspace(model);
  for (std::size_t i = 0; i < values.size(); ++i) {
    Response alone = make_response(model);
    run(model, {&values[i], 1}, workspace, alone);
    EXPECT_TRUE(bits_of(together[i]) == bits_of(alone)) << i;
  }
  EXPECT_EQ(together[4].status, Status::InvalidParameter);
}

TEST(MotionLanes, HandOverNothingOnceTheyAreStopped) {
  const std::vector<BatchCase> cases =
      eleven_motions([](std::size_t i) { return struck(i, YieldModel::Elastic, false); },
                     Scheme::GeneralizedAlpha, InstructionSet::Auto);
  std::atomic<bool> stop{true};
  BatchOptions options;
  options.stop = &stop;
  for (const BatchRow& row : run_batch(cases, options)) EXPECT_EQ(row.response.samples, 0U);
}

}  // namespace
}  // namespace plastica
