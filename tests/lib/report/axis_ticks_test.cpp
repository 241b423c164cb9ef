#include "plastica/report/axis_ticks.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace plastica::report {
namespace {

std::vector<std::string> texts_of(const std::array<double, 2>& range, double panel) {
  std::vector<std::string> texts;
  for (const AxisTick& tick : ticks_with_room(range, panel)) texts.push_back(tick.text);
  return texts;
}

TEST(AxisTicks, AreMultiplesOfARoundStep) {
  EXPECT_EQ(texts_of({-0.1, 1.05}, 300.0),
            (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(texts_of({199.99, 200.011}, 700.0),
            (std::vector<std::string>{"199.99", "199.995", "200", "200.005", "200.01"}));
}

TEST(AxisTicks, AreTwoAtLeastAndDifferInTheirTexts) {
  for (const double middle : {1.0, 9.99, 200.0, 277.3, 12345.678, -3.2e-4}) {
    for (double part = 1e-9; part < 2.0; part *= 3.3) {
      for (const double panel : {180.0, 230.0, 296.0, 770.0}) {
        const double half = part * std::fabs(middle);
        const std::array<double, 2> range{middle - half, middle + half};
        const std::vector<AxisTick> ticks = ticks_with_room(range, panel);
        EXPECT_GE(ticks.size(), 2U) << middle << ' ' << part << ' ' << panel;
        std::set<std::string> texts;
        for (const AxisTick& tick : ticks) {
          EXPECT_GE(tick.at, range[0] - 1e-6 * half);
          EXPECT_LE(tick.at, range[1] + 1e-6 * half);
          EXPECT_NEAR(std::stod(tick.text), tick.at, 0.02 * half) << tick.text;
          texts.insert(tick.text);
        }
        EXPECT_EQ(texts.size(), ticks.size()) << middle << ' ' << part << ' ' << panel;
      }
    }
  }
}

TEST(AxisTicks, LeaveOutALastOneThatWouldLeaveThePage) {
  for (const AxisTick& tick : ticks_with_room({0.0, 100000.0}, 300.0)) {
    EXPECT_LT(tick.at, 100000.0);
  }
}

}  // namespace
}  // namespace plastica::report
