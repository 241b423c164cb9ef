#include "sweeps/advise/adviser.hpp"

#include <gtest/gtest.h>

#include "plastica/io/scene_file.hpp"
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

  adviser.look_at(0.1 * adviser.best()->promised, runs.own());
  EXPECT_FALSE(adviser.best());
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
