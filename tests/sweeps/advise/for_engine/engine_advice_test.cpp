#include "sweeps/advise/for_engine/engine_advice.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "plastica/io/scene_file.hpp"
#include "sweeps/advise/for_engine/engine_advice_json.hpp"
#include "sweeps/advise/for_engine/engine_advice_text.hpp"
#include "sweeps/advise/for_engine/hinge_chain.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/advise/for_engine/engine_advice_scenes.hpp"

namespace plastica::testing {
namespace {

using sweeps::AdviceOptions;
using sweeps::EngineAdvice;
using sweeps::EngineAdviceEnd;

const sweeps::AdvisedEngine& kMujoco = *sweeps::advised_engine("mujoco");
const sweeps::AdvisedEngine& kBullet = *sweeps::advised_engine("bullet");

plastica::Setup setup_of(const std::string& text) {
  return io::parse_scene_file(text, "scene.toml").setup;
}

AdviceOptions within(double error) {
  AdviceOptions options;
  options.within = error;
  return options;
}

std::string refusal_of(const plastica::Setup& setup, const AdviceOptions& options = {}) {
  return message_of([&] { (void)sweeps::advise_for_engine(kMujoco, setup, options); });
}

TEST(EngineAdvice, IsTheCheapestOfThoseThatItTried) {
  const AdviceOptions options = within(0.02);
  const EngineAdvice advice =
      sweeps::advise_for_engine(kMujoco, setup_of(released_strip()), options);
  ASSERT_EQ(advice.end, EngineAdviceEnd::Found);
  EXPECT_FALSE(advice.cut_short);
  EXPECT_DOUBLE_EQ(advice.promised, advice.error + advice.reference_error);
  EXPECT_LE(advice.reference_error, 0.25 * options.within);
  EXPECT_EQ(advice.beam.segments.size(), static_cast<std::size_t>(advice.setting.segments));
  EXPECT_DOUBLE_EQ(advice.beam.time_step, advice.time_step);
  // 50 samples in a second.
  EXPECT_NEAR(advice.time_step * advice.setting.steps, 0.02, 1e-12);
  EXPECT_EQ(advice.work, advice.setting.segments * advice.setting.steps * 50);
  ASSERT_TRUE(advice.next_cheaper.has_value());
  EXPECT_LT(advice.next_cheaper->work, advice.work);
  // It is off by more, or by more with twice the segments or steps, of which the reason tells.
  EXPECT_TRUE(advice.next_cheaper->error > options.within - advice.reference_error ||
              !advice.next_cheaper->reason.empty());
  // Fewer of either alone do not do.
  EXPECT_GT(advice.error, 0.7 * options.within);
}

TEST(EngineAdvice, SaysWhatAPersonAndAScriptNeed) {
  const AdviceOptions options = within(0.05);
  const EngineAdvice advice = sweeps::advise_for_engine(kMujoco, setup_of(struck_bar()), options);
  ASSERT_EQ(advice.end, EngineAdviceEnd::Found);
  const std::string text = sweeps::engine_advice_text(advice, options, "bar.toml");
  for (const char* part :
       {"bar.toml for mujoco, within 5 %:\n", "  segments         = ", "  step             = ",
        "  joint stiffness  = ", "N m s/rad, none, as in the scene", "  joint armature   = ",
        "at most ", "next cheaper, not within: ", "note: loads are not in the file"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
  }
  const std::string json = sweeps::engine_advice_json(advice, options, "bar.toml");
  for (const char* part : {"\"engine\": \"mujoco\"", "\"end\": \"found\"", "\"damping\": \"none\"",
                           "\"name\": \"joint_1\"", "\"next_cheaper\": {"}) {
    EXPECT_NE(json.find(part), std::string::npos) << part << '\n' << json;
  }
}

TEST(EngineAdvice, KnowsWhatMujocosBeamLeavesOut) {
  // Shear is some 3 % of the deflection of a beam five times as long as deep.
  const plastica::Setup stocky = setup_of(plastic_strip(
      "duration = '10 ms'\nsteps = 40\n",
      "[gravity]\nacceleration = ['0 m/s^2', '-9.81 m/s^2', '0 m/s^2']\nhistory = 'constant'\n" +
          tip_probe("y"),
      "100 mm"));
  const AdviceOptions options = within(0.005);
  const EngineAdvice advice = sweeps::advise_for_engine(kMujoco, stocky, options);
  EXPECT_EQ(advice.end, EngineAdviceEnd::AtLimit);
  EXPECT_GT(advice.error, 0.01);
  const std::string text = sweeps::engine_advice_text(advice, options, "stocky.toml");
  EXPECT_NE(text.find("nothing within 0.5 %: more segments and shorter steps do not help"),
            std::string::npos)
      << text;
  EXPECT_NE(sweeps::engine_advice_json(advice, options, "").find("\"promised\": null"),
            std::string::npos);
}

TEST(EngineAdvice, RefusesWhatAnExportDoesNotHold) {
  const plastica::Setup good = setup_of(struck_bar());
  plastica::Setup bad = good;
  bad.solver.analysis = Analysis::Statics;
  EXPECT_EQ(refusal_of(bad),
            "solver.analysis: must be \"dynamics\" with --for: it advises the step of a motion");
  bad = good;
  bad.scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  EXPECT_EQ(refusal_of(bad),
            "support[2]: is off the beam's start: advice for mujoco is for beams that are held at "
            "their start alone");
  bad = good;
  bad.scene.supports.clear();
  EXPECT_EQ(refusal_of(bad),
            "support: is missing: advice for mujoco is for beams that are held at their start");
  bad = good;
  bad.scene.supports[0].translation = {0.0, 0.1, 0.0};
  EXPECT_NE(refusal_of(bad).find("support[1]: moves: "), std::string::npos) << refusal_of(bad);
  bad = good;
  bad.scene.supports = {{.kind = SupportKind::Elastic, .stiffness = {1.0, 1.0, 1.0}}};
  EXPECT_EQ(refusal_of(bad), "support[1]: is of kind elastic, which no export has");
  bad = good;
  bad.scene.initial_motions.push_back({.velocity = {0.0, 1.0, 0.0}});
  EXPECT_EQ(refusal_of(bad), "initial_motion: does not go with --for: an export has no velocities");
  bad = good;
  bad.scene.cuts.push_back({.time = 0.1});
  EXPECT_EQ(refusal_of(bad), "cut: does not go with --for: mujoco has no joint that breaks");
}

// Bullet has no armature: its step must be below 2/w of the highest frequency.
TEST(EngineAdvice, StaysBelowTheStableStepOfBullet) {
  const plastica::Setup setup = setup_of(struck_bar());
  const AdviceOptions options = within(0.02);
  const EngineAdvice bullet = sweeps::advise_for_engine(kBullet, setup, options);
  ASSERT_EQ(bullet.end, EngineAdviceEnd::Found);
  EXPECT_LT(bullet.time_step, sweeps::advise_for_engine(kMujoco, setup, options).time_step);
  EXPECT_EQ(bullet.beam.joints[1].rotation[0], calibrate::JointHold::Sprung);
  EXPECT_EQ(bullet.beam.joints[1].rotation[1], calibrate::JointHold::Rigid);
  // Every mode is moved, for much longer than the scene lasts.
  sweeps::HingeChain chain(kBullet, bullet.beam, {true, false, false});
  const std::vector<double> still(chain.freedoms(), 0.0);
  std::vector<double> speeds(chain.freedoms(), 0.0);
  speeds.back() = 1e-3;
  chain.set_state(still, speeds);
  const std::vector<sweeps::SegmentWrench> none(chain.size());
  for (int i = 0; i < 100 * setup.solver.steps * bullet.setting.steps; ++i) {
    ASSERT_TRUE(chain.step({}, none)) << i;
    ASSERT_LT(std::abs(chain.coordinate(chain.freedoms() - 1)), 1e-3) << i;
  }
}

// Twice as many segments take 16 times as many steps of explicit dampers. The first that do not
// blow up are off by 51 and 194 %, which says nothing of segments.
TEST(EngineAdvice, DoesNotTakeAStepTooLongForAnErrorOfSegments) {
  struct Expected {
    const char* damping_time;
    double most_work;  // half as much again as what the search finds
  };
  for (const auto& [damping_time, most_work] :
       {Expected{"2 ms", 1.2e5}, Expected{"0.05 ms", 2e4}}) {
    SCOPED_TRACE(damping_time);
    const EngineAdvice advice =
        sweeps::advise_for_engine(kBullet, setup_of(damped_bar(damping_time)), within(0.02));
    ASSERT_EQ(advice.end, EngineAdviceEnd::Found);
    EXPECT_LE(advice.setting.segments, 8);
    EXPECT_LT(static_cast<double>(advice.work), most_work);
    EXPECT_LE(advice.promised, 0.02);
    // Half the step all but nothing: it is well within what is stable.
    EXPECT_LT(advice.by_steps, 1e-4);
    for (const sweeps::TriedEngineSetting& one : advice.tried) {
      // No finite run at a step up to a tenth longer is off by more than its segments are.
      const bool is_longer = one.setting.segments == advice.setting.segments &&
                             one.time_step > advice.time_step &&
                             one.time_step < 1.1 * advice.time_step;
      EXPECT_TRUE(!is_longer || one.error < 0.02) << one.time_step;
    }
  }
}

TEST(EngineAdvice, SpeaksOfBulletAsOfMujoco) {
  const AdviceOptions options = within(0.05);
  const EngineAdvice bullet = sweeps::advise_for_engine(kBullet, setup_of(struck_bar()), options);
  const std::string text = sweeps::engine_advice_text(bullet, options, "bar.toml");
  EXPECT_TRUE(text.starts_with("bar.toml for bullet, within 5 %:\n")) << text;
  EXPECT_EQ(text.find("armature"), std::string::npos) << text;
  EXPECT_NE(text.find(" by Bullet's rule\n"), std::string::npos) << text;
  EXPECT_NE(text.find("addLinkForce"), std::string::npos) << text;
  EXPECT_NE(sweeps::engine_advice_json(bullet, options, "").find("\"engine\": \"bullet\""),
            std::string::npos);
}

TEST(EngineAdvice, RefusesWhatYieldsOrBreaks) {
  plastica::Setup bad = setup_of(struck_bar());
  bad.scene.yield_model = YieldModel::PerAxis;
  bad.scene.material.yield_stress = 1e9;
  EXPECT_EQ(sweeps::advise_for_engine(kMujoco, bad, within(0.1)).end, EngineAdviceEnd::Found);
  bad.scene.material.yield_stress = 1e6;
  EXPECT_NE(refusal_of(bad).find("rules.yield_model: lets the beam yield here (plastic work "),
            std::string::npos)
      << refusal_of(bad);
  bad.scene.material.break_strain = 1e-5;
  EXPECT_NE(refusal_of(bad).find("material.break_strain: is exceeded after "), std::string::npos)
      << refusal_of(bad);
}

TEST(EngineAdvice, LooksAtWhatAnEngineHas) {
  plastica::Setup setup = setup_of(struck_bar());
  setup.scene.probes.push_back(
      {.name = "kinetic", .quantity = ProbeQuantity::Energy, .energy = EnergyKind::Kinetic});
  const EngineAdvice advice = sweeps::advise_for_engine(kMujoco, setup, within(0.1));
  EXPECT_EQ(advice.left_out, std::vector<std::string>{"kinetic"});
  AdviceOptions options = within(0.1);
  options.probes = {"kinetic"};
  EXPECT_EQ(refusal_of(setup, options),
            "--of = kinetic: is no displacement, rotation, velocity or spin, which alone are "
            "compared with --for");
  setup.scene.probes[0].component = Component::X;  // across the plane of the motion
  EXPECT_NE(refusal_of(setup, within(0.1)).find("probe: stays within rounding"), std::string::npos);
  setup.scene.probes.erase(setup.scene.probes.begin());
  EXPECT_EQ(refusal_of(setup),
            "probe: is missing: advice with --for needs a displacement, rotation, velocity or spin "
            "to look at");
}

TEST(EngineAdvice, EndsInOrderWhereverItIsStopped) {
  const plastica::Setup setup = setup_of(struck_bar());
  int found = 0;
  for (int runs = 4; runs < 40; runs += 7) {
    AdviceOptions options = within(0.02);
    options.max_runs = runs;
    const EngineAdvice advice = sweeps::advise_for_engine(kMujoco, setup, options);
    EXPECT_LE(advice.runs, 3 * runs);
    if (advice.end != EngineAdviceEnd::Found) continue;
    ++found;
    EXPECT_LE(advice.promised, 0.02);
  }
  EXPECT_GT(found, 0);
  for (int calls = 1; calls < 30; calls += 7) {
    std::atomic<bool> stop = false;
    std::atomic<int> done = 0;
    AdviceOptions options = within(0.02);
    options.stop = &stop;
    options.progress = [&](int) { stop = ++done >= calls; };
    const EngineAdvice advice = sweeps::advise_for_engine(kMujoco, setup, options);
    EXPECT_EQ(advice.end, EngineAdviceEnd::Interrupted) << calls;
    const std::string text = sweeps::engine_advice_text(advice, options, "bar.toml");
    EXPECT_NE(text.find("interrupted"), std::string::npos);
    EXPECT_EQ(text.find("= 0 s"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace plastica::testing
