#include "sweeps/advise/advice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "sweeps/advise/advice_runs.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "sweeps/advise/watched_probes.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"
#include "tests/sweeps/places_alike.hpp"
#include "tests/sweeps/robot_arm.hpp"

namespace plastica::sweeps {
namespace {

using testing::message_of;

/// 20 mm square: it is hardly bent, and shear adds 3e-4.
Setup cantilever() { return tip_cantilever(0.02, "['0 N', '-1 N', '0 N']"); }

TEST(Advice, IsWithinWhatWasAskedOfTheClosedForm) {
  const plastica::Setup setup = cantilever();
  const double exact = -bending_deflection(setup, 1.0) * (1.0 + shear_ratio(setup));
  for (const double within : {0.05, 0.01, 0.002, 1e-4}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << within;
    const double error = std::abs(end_of(setup, advice) / exact - 1.0);
    EXPECT_LE(error, advice.promised) << within;
    EXPECT_LE(advice.promised, within);
    // The cheapest by the law 1/(4 N^2) of this beam takes sqrt(1/(4 within)) segments.
    EXPECT_LE(advice.setting[0], std::max(4.0, 2.5 * std::sqrt(0.25 / within))) << within;
  }
}

TEST(Advice, LooksAtBucklingLoadsOfAColumnThatDoesNotMove) {
  // Euler's factors 2 and 8 in the plane of least stiffness, see the scene.
  const plastica::Setup setup = shipped_scene("column");
  const Advice advice = advise(setup, asked(0.01));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  EXPECT_GT(advice.setting[0], 4.0);
  const plastica::Setup at = advised_setup(setup, advice);
  const Response response = simulate(at.scene, at.solver);
  ASSERT_TRUE(response.buckling.has_value());
  EXPECT_NEAR(response.buckling->factor[0], 2.0, 0.01 * 2.0);
}

TEST(Advice, OfTheRobotsArmHoldsAgainstARunThatIsFinestInBoth) {
  const plastica::Setup setup = shipped_scene("robot_arm");
  const Advice advice = advise(setup, asked(0.03));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const auto watched = watched_probes(setup, {}).watched;
  const auto run = [&](const plastica::Setup& at) {
    return outcome_of(run_case({"arm", at.scene, at.solver}), watched);
  };
  const Outcome advised = run(advised_setup(setup, advice));
  const Outcome finer = run(finer_setup(setup, advice, 0.25));
  EXPECT_LE(deviation(advised, finer, watched).largest, advice.promised);
}

TEST(Advice, LeavesOutTheAngleOfAJointThatFallsWithItsLength) {
  plastica::Setup setup = shipped_scene("cantilever");
  setup.scene.yield_model = YieldModel::Elastic;
  setup.scene.probes = {{"tip", ProbeQuantity::Displacement},
                        {"bend", ProbeQuantity::Angle, {0.5, {}}, Component::X}};
  const WatchedProbes found = watched_probes(setup, {});
  EXPECT_EQ(found.watched.size(), 1U);
  EXPECT_EQ(found.left_out, std::vector<std::string>{"bend"});
  EXPECT_TRUE(testing::message_of([&] {
                watched_probes(setup, {"bend"});
              }).ends_with("falls with the joint's length; name a rotation"));
  setup.scene.supports.push_back({.at = {0.5, {}}, .kind = SupportKind::Hinge});
  EXPECT_EQ(watched_probes(setup, {}).watched.size(), 2U) << "a hinge turns as it does";
  setup.scene.supports.pop_back();
  setup.scene.probes[1].at = Place::start();
  EXPECT_EQ(watched_probes(setup, {}).left_out.size(), 1U) << "the clamp's";
  setup.scene.supports[0].kind = SupportKind::Pin;
  EXPECT_EQ(watched_probes(setup, {}).watched.size(), 2U) << "a pin's is the beam's slope";
  setup.scene.probes[1].at = {0.5, {}};
  setup.scene.yield_model = YieldModel::PerAxis;
  EXPECT_EQ(watched_probes(setup, {}).watched.size(), 2U) << "one may form";
}

TEST(Advice, IsNotTakenInByTwoRunsOnTheSameWrongSideOfALimit) {
  // With 10 segments the beam swings out of the way of the load and with 20, too; the limit load of
  // 1.5 first yields (see the scene) is found by 32 and more.
  const plastica::Setup setup = shipped_scene("limit_load_cantilever");
  const Advice advice = advise(setup, asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  const plastica::Setup at = advised_setup(setup, advice);
  const Response response = simulate(at.scene, at.solver);
  ASSERT_TRUE(response.limit.has_value());
  EXPECT_NEAR(response.limit->below, 0.8875, advice.promised * 0.8875);
}

TEST(Advice, SaysWhereItFindsNothing) {
  // The force of an impact has no limit that refinement comes to.
  AdviceOptions options = asked(0.001);
  options.max_work = 2e5;
  const Advice advice = advise(shipped_scene("crash_bumper"), options);
  EXPECT_EQ(advice.end, AdviceEnd::TooMuchWork);
  EXPECT_NE(advice_text(advice, options, "crash_bumper.toml").find("nothing within 0.1 %"),
            std::string::npos);
}

TEST(Advice, NamesTheQuantityThatIsNotWithinWhereverItEnds) {
  const plastica::Setup setup = shipped_scene("robot_arm");
  for (int runs = 4; runs < 20; ++runs) {
    AdviceOptions options = asked(1e-3);
    options.max_runs = runs;
    const Advice advice = advise(setup, options);
    if (advice.end == AdviceEnd::Found) break;
    EXPECT_EQ(advice.worst.find("gripper: "), 0u) << runs;
    // An axis that no run has measured is not free of error.
    for (const BudgetLine& line : advice.budget) EXPECT_GT(line.error, 0.0) << runs;
  }
  AdviceOptions options = asked(1e-3);
  options.max_work = 2e5;
  const Advice impact = advise(shipped_scene("crash_bumper"), options);
  EXPECT_FALSE(impact.worst.empty());
}

TEST(CostLimit, IsWhatIsLeftOfAllWorkOrManyTimesWhatWasForeseen) {
  EXPECT_EQ(cost_limit(1e6, 1e5).cost, 1e6);
  EXPECT_TRUE(cost_limit(1e6, 1e5).of_all_work);
  EXPECT_EQ(cost_limit(1e6, 10.0).cost, 2000.0);
  EXPECT_FALSE(cost_limit(1e6, 10.0).of_all_work);
}

TEST(Advice, StopsARunThatTakesMoreThanAllWork) {
  // Nothing is foreseen of the first run: 3000 steps of four segments, several iterations each.
  const plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-400 N', '0 N']", "yield_model = 'fibre'", "steps = 3000");
  AdviceOptions options = asked(0.05);
  options.max_work = 1e4;
  const Advice advice = advise(setup, options);
  EXPECT_EQ(advice.end, AdviceEnd::TooMuchWork);
  EXPECT_EQ(advice.runs, 1);
  EXPECT_GT(advice.total_work, 1000);
  EXPECT_LT(advice.total_work, 1.2e4);
}

TEST(Advice, EndsInOrderWhereverItIsStopped) {
  const plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-400 N', '0 N']", "yield_model = 'fibre'", "steps = 10");
  int found = 0;
  for (int runs = 4; runs < 40; ++runs) {
    AdviceOptions options = asked(0.05);
    options.max_runs = runs;
    const Advice advice = advise(setup, options);
    EXPECT_LE(advice.runs, runs);
    const bool ends = advice.end == AdviceEnd::Found || advice.end == AdviceEnd::TooManyRuns;
    EXPECT_TRUE(ends) << runs;
    found += advice.end == AdviceEnd::Found ? 1 : 0;
  }
  EXPECT_GT(found, 0);
  for (int runs = 1; runs < 12; ++runs) {
    std::atomic<bool> stop = false;
    AdviceOptions options = asked(0.05);
    options.stop = &stop;
    options.progress = [&](int done) { stop = done >= runs; };
    const Advice advice = advise(setup, options);
    const bool in_time = advice.end == AdviceEnd::Found && advice.runs <= runs;
    EXPECT_TRUE(in_time || advice.end == AdviceEnd::Interrupted) << runs;
  }
}

TEST(Advice, IsNotTakenInByPlacesThatStandAlikeInTwoDivisions) {
  const plastica::Setup setup = places_alike(32);
  const Advice advice = advise(setup, asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  const plastica::Setup fine = places_alike(2000);
  const std::vector<BatchCase> cases{{"advised", advised_setup(setup, advice).scene, setup.solver},
                                     {"fine", fine.scene, fine.solver}};
  const std::vector<BatchRow> rows = run_batch(cases);
  const double truth = rows[1].response.probes[0].back();
  EXPECT_NEAR(rows[0].response.probes[0].back(), truth, 0.05 * std::abs(truth));
}

/// A joint's probe within a segment is of the nearest joint, which may be the same one in N and 2N.
TEST(Advice, SeesWhatProbesOfJointsAreOffWithinSegments) {
  for (const double at : {0.8, 0.37}) {
    const plastica::Setup setup =
        io::parse_scene_file(
            "material = 'S355'\n[beam]\nlength = '2 m'\nsegments = 32\n"
            "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
            "[rules]\nyield_model = 'elastic'\n[solver]\nsteps = 2\n"
            "[[support]]\nat = 'start'\nkind = 'clamp'\n"
            "[[load]]\nat = 'end'\nforce = ['0 N', '-3 N', '0 N']\n"
            "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n"
            "[[probe]]\nname = 'bend'\nkind = 'moment'\ncomponent = 'x'\nat = " +
                std::to_string(at) + "\n",
            "probed.toml")
            .setup;
    const double truth = 3.0 * 2.0 * (1.0 - at);  // [N m]; the tip comes 1e-6 of the length closer
    for (const double within : {0.05, 0.01, 0.002}) {
      const Advice advice = advise(setup, asked(within));
      ASSERT_EQ(advice.end, AdviceEnd::Found);
      const plastica::Setup at_advice = advised_setup(setup, advice);
      const double bend = simulate(at_advice.scene, at_advice.solver).probes[1].back();
      EXPECT_NEAR(std::abs(bend), truth, within * truth) << at << ", within " << within;
      const plastica::Setup finer = finer_setup(setup, advice, 0.25);
      EXPECT_NEAR(std::abs(simulate(finer.scene, finer.solver).probes[1].back()), truth,
                  1e-4 * truth);
    }
  }
}

TEST(Advice, GoesOnWhereACoarseBeamHoldsStillWhatAFinerOneMoves) {
  // With end segments that are clamped rigidly nothing of four segments moves under these.
  plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-2000 N', '0 N']");
  setup.scene.supports.push_back({.at = Place::end(), .kind = SupportKind::Roller});
  setup.scene.loads[0].at = {0.03, {}};
  setup.scene.probes[0].at = {0.013, {}};
  const Advice advice = advise(setup, asked(0.05));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  plastica::Setup fine = setup;
  fine.scene.beam.segments = 4000;
  fine.solver.translation = JointTranslation::Elastic;
  const double truth = simulate(fine.scene, fine.solver).probes[0].back();
  EXPECT_NEAR(end_of(setup, advice), truth, 0.05 * std::abs(truth));
}

/// Half of a segment yields here, of a coarse beam nothing: that a quantity has not changed there
/// says nothing of a finer one.
TEST(Advice, LooksAgainAtNumbersThatChangedNothingWhileNothingYielded) {
  plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-560 N', '0 N']", "yield_model = 'fibre'", "steps = 20");
  setup.scene.loads[0].history = History::turning_points({1.0, 0.0});
  Probe& probe = setup.scene.probes[0];
  probe.quantity = ProbeQuantity::Energy;
  probe.energy = EnergyKind::Plastic;
  const Advice advice = advise(setup, asked(0.02));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  plastica::Setup fine = setup;
  fine.scene.beam.segments = 400;
  fine.solver.fibres = 1000;
  fine.solver.steps = 40;
  const double truth = simulate(fine.scene, fine.solver).probes[0].back();
  ASSERT_GT(truth, 0.0);
  EXPECT_NEAR(end_of(setup, advice), truth, 0.02 * truth);
}

/// Steps of a multiple of its half period see nothing of a sine, however many there are.
TEST(Advice, BeginsWithStepsThatSeeEverySwing) {
  plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']", "yield_model = 'elastic'",
                                         "analysis = 'dynamics'\nduration = '40 ms'\nsteps = 10");
  EXPECT_TRUE(std::isinf(resolving_step(setup)));
  EXPECT_DOUBLE_EQ(fineness_axes(setup)[1].coarsest, 4e-3);
  setup.scene.loads[0].history = History::smooth_step(1e-3, 3e-3);
  EXPECT_NEAR(resolving_step(setup), 0.5e-3, 1e-12);
  for (const double cycles : {40.0, 33.3, 250.0}) {
    setup.scene.loads[0].history = History::sine(1e-3, cycles);
    EXPECT_NEAR(resolving_step(setup), 1e-3 / 8.0, 1e-9) << cycles;
    EXPECT_LE(fineness_axes(setup)[1].coarsest, 1.01e-3 / 8.0);
  }
  setup.solver.step_error = 1e-4;
  const auto axes = fineness_axes(setup);
  ASSERT_EQ(axes.size(), 3u);
  EXPECT_EQ(axes[1].field->path, "solver.step_error");
  EXPECT_EQ(axes[2].field->path, "solver.time_step");
  EXPECT_LE(axes[2].coarsest, 1.01e-3 / 8.0);
}

TEST(Advice, RefusesATolerance) {
  plastica::Setup setup = cantilever();
  setup.solver.tolerance = 0.1;
  EXPECT_EQ(message_of([&] { (void)advise(setup, asked(0.01)); }),
            "solver.tolerance = 0.1: must be at most 1e-6 for advice: all its runs have it, "
            "so that what it leaves would not be seen");
}

TEST(Advice, BeginsWithAsManySegmentsAsTheSceneNeeds) {
  // Four segments have no middle in the last tenth, so that nothing would move.
  const plastica::Setup setup =
      io::parse_scene_file(
          "[material]\nyoungs_modulus = '2 GPa'\npoisson_ratio = 0.3\ndensity = '1200 kg/m^3'\n"
          "[beam]\nlength = '1 m'\nsegments = 32\n"
          "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
          "[rules]\nyield_model = 'elastic'\n"
          "[solver]\nanalysis = 'dynamics'\nduration = '100 ms'\nsteps = 10\n"
          "[[support]]\nat = 'start'\nkind = 'clamp'\n"
          "[[initial_motion]]\nfrom = 0.9\nvelocity = ['0 m/s', '1 m/s', '0 m/s']\n"
          "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 'end'\ncomponent = 'y'\n",
          "thrown.toml")
          .setup;
  const Advice advice = advise(setup, asked(0.2));
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  EXPECT_GT(advice.setting[0], 4.0);
}

TEST(Advice, PromisesNothingAtTheFinestThereIs) {
  // 20 000 segments are 1/(4 N^2) = 6e-10 off, and none are finer.
  EXPECT_EQ(advise(cantilever(), asked(1e-11)).end, AdviceEnd::AtFinest);
}

TEST(Advice, RefusesWhatItCannotLookAt) {
  plastica::Setup setup = cantilever();
  EXPECT_EQ(message_of([&] { advise(setup, {.within = 0.01, .probes = {"top"}}); }),
            "--of = top: is no probe of the scene");
  setup.scene.probes[0].component = Component::X;
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "probe: stays within rounding, whatever is probed (tip): advice needs a probe of "
            "something that moves");
  setup.scene.probes[0].quantity = ProbeQuantity::LoadFactor;
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "probe: is missing: advice needs one to look at");
}

TEST(Advice, RefusesWhatHangsOnTheNumberOfSegments) {
  // The end of the third segment is elsewhere with each number of them.
  plastica::Setup setup = cantilever();
  setup.scene.probes[0].at.segment = 3;
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "probe.at: is the end of a segment, which moves with their number: give a fraction");
  setup = cantilever();
  setup.scene.beam.segments = 2;
  setup.scene.beam.segment_fractions = {0.25, 0.75};
  EXPECT_EQ(message_of([&] { advise(setup, asked(0.01)); }),
            "beam.segment_lengths: fixes the segments, whose number is to be chosen");
}

// Runs are compared at the samples that both have: of 20 and 29 recorded steps the first and the
// last.
TEST(Advice, RefinesTheRecordedStepsOfAPathByMultiples) {
  plastica::Setup setup;
  setup.scene.beam.segments = 8;
  setup.scene.supports.emplace_back();
  setup.scene.loads.push_back({.force = {0.0, -1.0, 0.0}});
  setup.scene.yield_model = YieldModel::PerAxis;
  setup.solver.steps = 20;
  const auto axes = fineness_axes(setup);
  ASSERT_EQ(axes.back().field->path, "solver.steps");
  for (const double factor : {0.7, 0.5, 0.33, 1e-4}) {
    Setting setting = own_setting(setup, axes);
    setting.back() = axes.back().scaled(setting.back(), factor);
    const double steps = taken_setting(setup, axes, setting).back();
    EXPECT_EQ(std::fmod(steps, 20.0), 0.0) << factor;
    EXPECT_GE(steps, std::min(20.0 / factor - 1e-9, axes.back().finest - 20.0)) << factor;
  }
}

}  // namespace
}  // namespace plastica::sweeps
