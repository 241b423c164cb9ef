#include "sweeps/advise/adviser.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "plastica/io/scene_file.hpp"
#include "sweeps/advise/axis_models.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"

namespace plastica::sweeps {
namespace {

TEST(Adviser, LooksAtOneSettingAlone) {
  const plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  const AdviceOptions options = asked(0.5);
  AdviceRuns runs(setup, options);
  Adviser adviser(runs);
  adviser.search(0.5);
  ASSERT_TRUE(adviser.best());
  const Candidate coarse = *adviser.best();
  ASSERT_LT(coarse.trial.setting[0], 16.0);
  adviser.look_at(coarse.promised, runs.own());
  ASSERT_TRUE(adviser.best());
  EXPECT_EQ(adviser.best()->trial.setting, runs.own().setting);
  EXPECT_LT(adviser.best()->promised, 0.5 * coarse.promised);
  EXPECT_GT(adviser.best()->promised, 0.0);
  for (std::size_t w = 0; w < adviser.best()->lines.size(); ++w) {
    for (const OtherWord& other : adviser.best()->lines[w].others) {
      EXPECT_NE(other.choice, adviser.best()->trial.words[w]) << "not another word";
    }
  }

  adviser.look_at(0.1 * adviser.best()->promised, runs.own());
  EXPECT_FALSE(adviser.best());
}

/// No clock decides this: any time is within the budget, and the runs do not last for a second
/// search.
TEST(AdviceForABudget, IsTheFilesOwnSettingWhereThatIsMoreAccurate) {
  plastica::Setup setup = tip_cantilever(0.02, "['0 N', '-1 N', '0 N']");
  setup.scene.beam.segments = 200;
  AdviceOptions options;
  options.budget = 1e9;
  options.max_runs = 14;
  const Advice advice = advise(setup, options);
  ASSERT_EQ(advice.end, AdviceEnd::Found) << advice.reason;
  EXPECT_EQ(advice.setting[0], 200.0);
  EXPECT_LT(advice.promised, 1e-4);
  EXPECT_EQ(advice.cut_short, AdviceEnd::TooManyRuns);
}

/// Of four and of eight fibres none yields: the outermost stands at 3/4, at 7/8 of half the depth.
TEST(Adviser, TakesNoSettingWhoseProbeIsAtRestWhereAFinerRunMovesIt) {
  plastica::Setup setup =
      tip_cantilever(0.02, "['0 N', '-520 N', '0 N']", "yield_model = 'fibre'", "steps = 20");
  setup.solver.fibres = 40;
  setup.scene.loads[0].history = History::turning_points({1.0, 0.0});
  Probe work = setup.scene.probes[0];
  work.name = "work";
  work.quantity = ProbeQuantity::Energy;
  work.energy = EnergyKind::Plastic;
  setup.scene.probes.push_back(work);
  const AdviceOptions options = asked(0.05);
  AdviceRuns runs(setup, options);
  Trial coarse = runs.own();
  const auto fibres = static_cast<std::size_t>(
      std::ranges::find(runs.axes(), "solver.fibres",
                        [](const FinenessAxis& axis) { return axis.field->path; }) -
      runs.axes().begin());
  ASSERT_LT(fibres, runs.axes().size());
  coarse.setting[fibres] = 4.0;
  Trial finer = coarse;
  finer.setting[fibres] = 8.0;
  ASSERT_TRUE(runs.run_all({coarse, finer}));
  EXPECT_EQ(runs.at_rest_where_finer_moves(coarse, finer), "");
  ASSERT_TRUE(runs.run_all({runs.own()}));
  EXPECT_EQ(runs.at_rest_where_finer_moves(coarse, finer), "work");
  EXPECT_EQ(runs.at_rest_where_finer_moves(coarse, runs.own()), "");

  Adviser adviser(runs);
  for (const double within : {0.5, 0.2, 0.05}) {
    adviser.search(within);
    if (!adviser.best()) continue;
    const auto& history = runs.outcome(adviser.best()->trial).history[1];
    EXPECT_GT(history.back(), 0.0) << within;
  }
  EXPECT_TRUE(adviser.best());
}

TEST(Adviser, AxisErrorsOfRunsInWhichNothingMovedAreNotKnown) {
  AxisModels models(2);
  models.measured(0, 0.25, 0.125, {.largest = 0.0, .quantity = "", .reason = "", .quantities = 0});
  EXPECT_TRUE(models.knows(0));
  models.measured(1, 0.1, 0.05, {.largest = 0.2, .quantity = "", .reason = "", .quantities = 3});
  EXPECT_FALSE(models.knows(0));
  EXPECT_TRUE(models.knows(1));
  models.measured(0, 0.25, 0.125, {.largest = 0.5, .quantity = "", .reason = "", .quantities = 3});
  EXPECT_TRUE(models.knows(0));
  models.forget(0);
  EXPECT_FALSE(models.knows(0));
}

}  // namespace
}  // namespace plastica::sweeps
