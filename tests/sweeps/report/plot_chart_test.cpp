#include "sweeps/report/plot_chart.hpp"
#include "tests/support/has.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

std::vector<std::string> texts_of(const ChartAxis& axis) {
  std::vector<std::string> texts;
  for (const ChartTick& tick : axis.ticks) texts.push_back(tick.text);
  return texts;
}

TEST(LogarithmicAxis, LabelsPowersOfTen) {
  const ChartAxis axis = logarithmic_axis("e", {2e-6, 500.0});
  EXPECT_LT(axis.range[0], 2e-6);
  EXPECT_GT(axis.range[1], 500.0);
  EXPECT_EQ(texts_of(axis), (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "10⁻⁴", "0.001", "0.01",
                                                      "0.1", "1", "10", "100", "1000"}));
}

TEST(LogarithmicAxis, LabelsTwoAndFiveWhereThereIsRoom) {
  EXPECT_EQ(texts_of(logarithmic_axis("e", {0.4, 9.0})),
            (std::vector<std::string>{"0.5", "1", "2", "5", "10"}));
}

TEST(LogarithmicAxis, LeavesOutPowersOfManyDecades) {
  EXPECT_LE(logarithmic_axis("e", {1e-14, 1e4}).ticks.size(), 13U);
}

TEST(LogarithmicAxis, HasRoomAroundOneValue) {
  const ChartAxis axis = logarithmic_axis("e", {3.0, 3.0});
  EXPECT_LT(axis.range[0], 3.0);
  EXPECT_GT(axis.range[1], 3.0);
}

TEST(AxisAtValues, LabelsWhatHasRoom) {
  EXPECT_EQ(texts_of(axis_at_values("n", {8, 4, 16, 4}, true)),
            (std::vector<std::string>{"4", "8", "16"}));
  EXPECT_EQ(texts_of(axis_at_values("n", {1, 1.01, 100}, false)),
            (std::vector<std::string>{"1", "100"}));
}

TEST(ChartLook, TellsEightApart) {
  std::vector<std::string> colors;
  for (std::size_t k = 0; k < kLooks; ++k) {
    for (const std::string& other : colors) EXPECT_NE(chart_look(k).color, other);
    colors.push_back(chart_look(k).color);
    EXPECT_EQ(chart_look(k).symbol % 2, 1) << "filled, so that one less is open";
  }
}

TEST(RampColor, GoesFromEndToEnd) {
  EXPECT_EQ(ramp_color(0.0), "#1B2A5E");
  EXPECT_EQ(ramp_color(1.0), "#E9B844");
  EXPECT_EQ(ramp_color(2.0), ramp_color(1.0));
}

Chart small_chart() {
  Chart chart{"it's", "sub", logarithmic_axis("x", {1, 10}), logarithmic_axis("y", {1, 10})};
  chart.series.push_back({"one", chart_look(0), {{1, 1}, {10, 10}}, {{5, 5}}});
  chart.guides = {2.0};
  return chart;
}

TEST(ChartPage, DrawsOpenSymbolsAndGuides) {
  const std::string script = chart_page(small_chart()).text();
  EXPECT_TRUE(has(script, "set logscale x\n") && has(script, "set logscale y\n")) << script;
  EXPECT_TRUE(has(script, "with linespoints linetype 1 linewidth 1.4 pointtype 7")) << script;
  EXPECT_TRUE(has(script, "with points pointtype 6")) << script;
  EXPECT_TRUE(has(script, "from graph 0, first 2 to graph 1, first 2 nohead")) << script;
  EXPECT_TRUE(has(script, "'it''s'"));
}

TEST(ChartTerminal, HasALetterForAColour) {
  Chart chart = small_chart();
  chart.series.push_back({"", chart_look(0), {{2, 2}}, {}});
  chart.series.push_back({"two", chart_look(1), {{3, 3}}, {}});
  const std::string script = chart_terminal(chart).text();
  EXPECT_TRUE(has(script, "pointtype '#' title 'one'")) << script;
  EXPECT_TRUE(has(script, "pointtype '#' notitle")) << script;
  EXPECT_TRUE(has(script, "pointtype 'o' title 'two'")) << script;
}

}  // namespace
}  // namespace plastica::sweeps
