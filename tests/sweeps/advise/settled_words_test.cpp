#include "sweeps/advise/settled_words.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "sweeps/advise/advice_text.hpp"
#include "tests/support/has.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"
#include "tests/sweeps/robot_arm.hpp"

namespace plastica::sweeps {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

/// Words that were decided with four segments, looked at with more.
struct Looked {
  Looked(plastica::Setup of, double within, double segments)
      : setup(std::move(of)), options(asked(within)), runs(setup, options), chooser(runs) {
    Trial trial = runs.own();
    for (std::size_t k = 0; k < runs.axes().size(); ++k) {
      trial.setting[k] = runs.axes()[k].coarsest;
    }
    EXPECT_TRUE(
        chooser.decide(runs.taken(trial), std::vector<AxisError>(runs.axes().size()), within));
    trial.words = chooser.words();
    trial.setting[0] = segments;
    candidate.trial = runs.taken(trial);
    candidate.errors.resize(runs.axes().size());
    candidate.errors[0].error = candidate.numbers = 0.1 * within;
  }

  plastica::Setup setup;
  AdviceOptions options;
  AdviceRuns runs;
  WordChooser chooser;
  Candidate candidate;
};

TEST(SettledWords, AreThoseThatLeaveOutShearWhateverTheNumberOfSegments) {
  const plastica::Setup setup = tip_cantilever(0.1, "['0 N', '-1 N', '0 N']");
  Looked looked(setup, 0.05, 12.0);
  SettledWords found;
  ASSERT_TRUE(measure_settled(looked.runs, looked.chooser, looked.candidate, 0.05, kAny, found));
  EXPECT_TRUE(found.are_so);
  const double shear = shear_ratio(setup) / (1.0 + shear_ratio(setup));
  EXPECT_GE(found.error, shear);
  EXPECT_LE(found.error, 1.1 * shear);
  // No room is left beside the numbers.
  looked.candidate.numbers = 0.05 - 0.5 * shear;
  ASSERT_TRUE(measure_settled(looked.runs, looked.chooser, looked.candidate, 0.05, kAny, found));
  EXPECT_FALSE(found.are_so);
}

TEST(SettledWords, AreNotThoseOfABeamThatYieldsWhereItIsFine) {
  Looked looked(shipped_scene("bend_and_release"), 0.05, 12.0);
  for (WordAxis& axis : looked.runs.word_axes()) {
    if (axis.field().path != "rules.yield_model") continue;
    const auto w = static_cast<std::size_t>(&axis - looked.runs.word_axes().data());
    looked.candidate.trial.words[w] = 0;
    looked.candidate.trial = looked.runs.taken(looked.candidate.trial);
    ASSERT_TRUE(axis.choices[0].text().starts_with("elastic"));
  }
  SettledWords found;
  ASSERT_TRUE(measure_settled(looked.runs, looked.chooser, looked.candidate, 0.05, kAny, found));
  EXPECT_FALSE(found.are_so);
}

TEST(SettledWords, AreNotLookedAtForMoreThanIsSaved) {
  Looked looked(tip_cantilever(0.1, "['0 N', '-1 N', '0 N']"), 0.05, 12.0);
  const int before = looked.runs.runs();
  SettledWords found;
  ASSERT_TRUE(measure_settled(looked.runs, looked.chooser, looked.candidate, 0.05, 1.0, found));
  EXPECT_FALSE(found.are_so);
  EXPECT_EQ(looked.runs.runs(), before);
}

TEST(SettledWords, AreWhatTheRunThatVerifiesHasAndTheirErrorIsPromised) {
  const plastica::Setup setup = tip_cantilever(0.06, "['0 N', '-1 N', '0 N']");
  const AdviceOptions options = asked(0.01);
  const Advice advice = advise(setup, options);
  ASSERT_EQ(advice.end, AdviceEnd::Found);
  ASSERT_EQ(told_of(advice, "solver.translation").chosen, "rigid");
  EXPECT_TRUE(advice.words_settled);
  const double shear = shear_ratio(setup);
  EXPECT_GE(advice.of_words, shear / (1.0 + shear));
  EXPECT_GE(advice.promised, advice.verified);
  EXPECT_GT(advice.verified, advice.of_words);
  const double exact = -bending_deflection(setup, 1.0) * (1.0 + shear);
  EXPECT_LE(std::abs(end_of(setup, advice) / exact - 1.0), advice.promised);
  EXPECT_TRUE(testing::has(advice_text(advice, options, "a"), ", and richest, is at most "));
  double cost = 0.0;
  for (const TriedSetting& one : advice.tried) cost += one.cost;
  EXPECT_LE(cost, 12.0 * advice.cost);
}

}  // namespace
}  // namespace plastica::sweeps
