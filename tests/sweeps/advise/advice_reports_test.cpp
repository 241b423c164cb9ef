#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "sweeps/advise/advice_json.hpp"
#include "sweeps/advise/advice_plot.hpp"
#include "sweeps/advise/advice_text.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/advise/advised_scenes.hpp"

namespace plastica::sweeps {
namespace {

using testing::has;

/// Stocky enough for shear to matter at 1 %.
Setup stocky() { return tip_cantilever(0.25, "['0 N', '-1 N', '0 N']"); }

TEST(AdviceText, SaysWhatTheNextSimplerWordWouldCostAndBeOff) {
  const AdviceOptions options = asked(0.01);
  const Advice advice = advise(stocky(), options);
  const std::string text = advice_text(advice, options, "stocky.toml");
  const OtherWord* rigid = told_of(advice, "solver.translation").other("rigid");
  ASSERT_NE(rigid, nullptr);
  EXPECT_TRUE(has(text, "stocky.toml, within 1 %:\n")) << text;
  EXPECT_TRUE(has(text,
                  "solver.translation = elastic     error 0 %; rigid would be 0.5 times the "
                  "cost and "))
      << text;
  EXPECT_TRUE(has(text, "spatial would be 4 times the cost\n")) << text;
}

TEST(AdviceJson, HasWhatTheTextHasAndEveryRun) {
  const AdviceOptions options = asked(0.01);
  const plastica::Setup setup = stocky();
  const Advice advice = advise(setup, options);
  const auto json = nlohmann::json::parse(advice_json(advice, options, "stocky.toml"));
  EXPECT_EQ(json.at("scene"), "stocky.toml");
  EXPECT_EQ(json.at("end"), "found");
  EXPECT_EQ(json.at("within"), 0.01);
  EXPECT_TRUE(json.at("budget").is_null());
  EXPECT_EQ(json.at("promised"), advice.promised);
  EXPECT_EQ(json.at("numbers").at(0).at("field"), "beam.segments");
  EXPECT_EQ(json.at("numbers").at(0).at("value"), advice.setting[0]);
  EXPECT_EQ(json.at("words").size(), advice.word_axes.size());
  bool found = false;
  for (const auto& word : json.at("words")) {
    if (word.at("field") != "solver.translation") continue;
    found = true;
    EXPECT_EQ(word.at("word"), "elastic");
    EXPECT_EQ(word.at("in_file"), "rigid");
    EXPECT_EQ(word.at("others").at(0).at("word"), "rigid");
    EXPECT_GT(word.at("others").at(0).at("error"), 0.03);
  }
  EXPECT_TRUE(found);
  EXPECT_EQ(json.at("runs"), advice.runs);
  EXPECT_EQ(json.at("tried").size(), advice.tried.size());
  std::int64_t work = 0;
  for (const auto& one : json.at("tried")) work += one.at("segment_iterations").get<std::int64_t>();
  EXPECT_EQ(work, json.at("total_segment_iterations"));
}

TEST(AdvicePlot, HasTheRunsTheFrontTheChoiceAndTheLineOfTheTolerance) {
  const AdviceOptions options = asked(0.01);
  const std::string script = advice_plot_script(advise(stocky(), options), options, "stocky.toml");
  for (const char* part : {"Pareto front", "with the advised words", "with other words", "advised",
                           "advice within 1 %", "first 1 to graph 1"}) {
    EXPECT_TRUE(has(script, part)) << part;
  }
}

TEST(AdvicePlot, RefusesWhatHasNoErrors) {
  const AdviceOptions options = asked(0.01);
  EXPECT_EQ(testing::message_of([&] { advice_plot_script(Advice{}, options, "a"); }),
            "--plot: has nothing to draw: no setting has an error");
}

Advice for_budget(double seconds) {
  AdviceOptions options;
  options.budget = seconds;
  return advise(stocky(), options);
}

TEST(AdviceForABudget, TakesNoLongerAndIsMoreAccurateForMore) {
  // The coarsest takes some 30 us: noise of a factor of ten does not turn this round.
  const Advice little = for_budget(3e-3);
  const Advice more = for_budget(0.03);
  for (const Advice* one : {&little, &more}) ASSERT_EQ(one->end, AdviceEnd::Found);
  EXPECT_LE(little.expected_seconds, 3e-3);
  EXPECT_LE(more.expected_seconds, 0.03);
  EXPECT_LT(more.promised, little.promised);
  const plastica::Setup setup = stocky();
  const double exact = -bending_deflection(setup, 1.0) * (1.0 + shear_ratio(setup));
  EXPECT_LE(std::abs(end_of(setup, little) / exact - 1.0), little.promised);
}

TEST(AdviceForABudget, SaysWhatTheCheapestCostsWhereThatIsTooMuch) {
  const Advice advice = for_budget(1e-9);
  EXPECT_EQ(advice.end, AdviceEnd::TooDear);
  AdviceOptions options;
  options.budget = 1e-9;
  const std::string text = advice_text(advice, options, "stocky.toml");
  EXPECT_TRUE(has(text,
                  "stocky.toml: nothing for 1e-06 ms: what is cheapest takes longer; the "
                  "cheapest setting:\n"))
      << text;
  EXPECT_TRUE(has(text, "\n  cost ")) << text;
}

}  // namespace
}  // namespace plastica::sweeps
