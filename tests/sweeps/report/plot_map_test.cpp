#include <gtest/gtest.h>

#include <cmath>

#include "sweeps/report/case_map.hpp"
#include "sweeps/report/plot.hpp"
#include "sweeps/report/plot_charts.hpp"
#include "sweeps/report/plot_classes.hpp"
#include "sweeps/report/web/web_map.hpp"
#include "tests/support/has.hpp"
#include "tests/support/message.hpp"
#include "tests/sweeps/run_record.hpp"

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

SweepRecord grid(const std::string& more = "", const std::string& error = kTipError) {
  return record_of(segments_axis("[4, 8, 16]") +
                   "[[axis]]\nfield = 'scale.loads'\nvalues = [0.5, 1]\n" + more + error);
}

PlotCases all_of(const SweepRecord& record) {
  return {record, std::vector<bool>(record.cases(), true)};
}

using Bounds = std::vector<double>;

TEST(BoundsBetween, AreAsFineAsFewClassesAllow) {
  EXPECT_EQ(bounds_between(0.6, 3.0), (Bounds{0.5, 1.0, 2.0, 5.0}));
  const Bounds halves = bounds_between(0.2, 90.0);
  const Bounds expected{0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0};
  ASSERT_EQ(halves.size(), expected.size());
  for (std::size_t k = 0; k < halves.size(); ++k) EXPECT_DOUBLE_EQ(halves[k], expected[k]);
  const Bounds wide = bounds_between(1e-9, 50.0);
  ASSERT_EQ(wide.size(), 8U);
  EXPECT_DOUBLE_EQ(wide.front(), 1e-5);
  EXPECT_DOUBLE_EQ(wide.back(), 100.0);
}

TEST(Classify, SortsErrorsAndNamesFailures) {
  SweepRecord record = grid();
  const std::vector<double> errors{0.001, 0.012, 0.03, 0.0, 0.006, 0.006};
  for (std::size_t i = 0; i < 6; ++i) record.comparison.error[i] = -errors[i];
  record.comparison.error[4].reset();
  record.results[4].status = Status::NotConverged;
  const CaseClasses out = classify(all_of(record));
  EXPECT_EQ(out.what, "size of the error of tip, end [%]");
  std::vector<std::string> names;
  for (const auto& place : out.class_of) names.push_back(out.classes.at(place.value()).name);
  EXPECT_EQ(names, (std::vector<std::string>{"below 0.2 %", "1 … 2 %", "2 … 5 %", "below 0.2 %",
                                             "not-converged", "0.5 … 1 %"}));
  EXPECT_EQ(out.number[1], "1.2");
  EXPECT_EQ(out.number[4], "");
}

TEST(Classify, NamesTheReferenceAndWhatDoesNotConverge) {
  SweepRecord record = grid();
  for (std::size_t i = 0; i < 6; ++i) record.comparison.error[i] = 0.01;
  record.comparison.error[1].reset();
  record.comparison.reason[1] = kIsReference;
  record.comparison.error[2].reset();
  record.comparison.reason[2] = std::string(kNotConverged) + "breaks at joint 14, 15, 30";
  const CaseClasses out = classify(all_of(record));
  EXPECT_EQ(out.classes.at(out.class_of[1].value()).name, "reference");
  EXPECT_EQ(out.classes.at(out.class_of[2].value()).name, "not converged");
  record.comparison.lacks.assign(6, "solver.time_step");
  const std::string page = map_page(all_of(record)).text();
  EXPECT_TRUE(has(page, "that of solver.time_step is not in it")) << page;
}

TEST(Classify, SortsValuesWhereNothingIsCompared) {
  const SweepRecord record = grid("", "[error]\nprobe = 'tip'\n");
  const CaseClasses out = classify(all_of(record));
  EXPECT_EQ(out.what, "tip, end [m]");
  EXPECT_EQ(out.classes.size(), 7U);
  for (const auto& place : out.class_of) EXPECT_LT(place.value(), 7U);
}

TEST(MapPage, HasAFieldForEachCase) {
  const SweepRecord record = grid();
  const std::string script = sweep_plot_script(record, {"map", "", "x.svg"});
  EXPECT_GE(count_of(script, "with boxxyerror"), 2U) << script;
  EXPECT_TRUE(has(script, "set logscale x\n")) << "4 to 16";
  EXPECT_FALSE(has(script, "set logscale y\n")) << "0.5 to 1";
  EXPECT_EQ(count_of(script, "set label '"), 6U) << "each with its number";
}

TEST(MapPage, HasAPanelForEachValueOfOtherAxes) {
  const SweepRecord record =
      grid("[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\n");
  const std::string script = sweep_plot_script(record, {"map", "", "x.svg"});
  EXPECT_TRUE(has(script, "set title 'half_joint'") && has(script, "set title 'equal'")) << script;
  EXPECT_TRUE(has(script, "unset logscale")) << "of the panel that is the legend";
}

/// Where a value of an axis stands for several cases of what moves together with it.
TEST(MapPage, HasOneCaseInAFieldWhereAxesMoveTogether) {
  const std::string together =
      "[[axis]]\nfield = 'scale.loads'\nvalues = [1, 1, 2]\nzip = 'm'\n"
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal', 'equal']\nzip = 'm'\n";
  const SweepRecord record = record_of(segments_axis("[4, 8]") + together + kTipError);
  const std::string script = sweep_plot_script(record, {"map", "", "x.svg"});
  EXPECT_TRUE(has(script, "'half_joint'")) << script;
  EXPECT_TRUE(has(script, "'equal'"));
  // Words that the map's axis tells make no panels.
  const std::string told =
      "[[axis]]\nfield = 'scale.loads'\nvalues = [1, 2]\nzip = 'm'\n"
      "[[axis]]\nfield = 'rules.end_rule'\nvalues = ['half_joint', 'equal']\nzip = 'm'\n";
  const SweepRecord one = record_of(segments_axis("[4, 8]") + told + kTipError);
  EXPECT_FALSE(has(sweep_plot_script(one, {"map", "", "x.svg"}), "'equal'"));
}

TEST(MapPage, AsksForAChoiceOfManyPanels) {
  const SweepRecord record =
      grid("[[axis]]\nfield = 'beam.length'\nlinear = { from = '1 m', to = '2 m', count = 10 }\n");
  EXPECT_EQ(plastica::testing::message_of([&] {
              sweep_plot_script(record, {"map", "", "x.svg"});
            }),
            "--case: is needed: a picture has at most 9 maps, and there are 10; AXIS = VALUE, … "
            "picks some");
  EXPECT_NO_THROW(sweep_plot_script(record, {"map", "length = 1 m", "x.svg"}));
}

TEST(MapTerminal, IsMadeOfLetters) {
  const SweepRecord record = grid();
  const std::string script = sweep_plot_script(record, {"map", "", "-"});
  EXPECT_TRUE(has(script, "with points pointtype '.' title 'below ")) << script;
  EXPECT_FALSE(has(script, "boxxyerror"));
}

TEST(HasMap, NeedsTwoAxesOfNumbersThatAreCrossed) {
  EXPECT_TRUE(has_map(grid()));
  EXPECT_FALSE(has_map(two_groups()));
  EXPECT_FALSE(
      has_map(record_of("[[axis]]\nfield = 'beam.segments'\nvalues = [4, 8]\nzip = 'a'\n"
                        "[[axis]]\nfield = 'scale.loads'\nvalues = [1, 2]\nzip = 'a'\n" +
                        kTipError)));
}

TEST(WebMap, HasACellForEachCaseWithItsClass) {
  SweepRecord record = grid();
  record.comparison.error[4].reset();
  record.results[4].status = Status::NotConverged;
  const report::Json json = web_map("Map", case_map(all_of(record)), record, true);
  EXPECT_EQ(json["x_values"], report::Json({4.0, 8.0, 16.0}));
  EXPECT_EQ(json["y_values"], report::Json({0.5, 1.0}));
  ASSERT_EQ(json["maps"].size(), 1U);
  const report::Json& cells = json["maps"][0]["cells"];
  ASSERT_EQ(cells.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(cells[i]["case"], i);
    const report::Json& kind = json["classes"][cells[i]["class"].get<std::size_t>()];
    EXPECT_EQ(kind.contains("fraction"), i != 4) << kind;
    const auto& error = record.comparison.error[i];
    EXPECT_EQ(cells[i]["amount"],
              report::number(error ? std::optional(100.0 * std::abs(*error)) : std::nullopt));
  }
}

}  // namespace
}  // namespace plastica::sweeps
