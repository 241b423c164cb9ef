#include "plastica/model/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace plastica {
namespace {

const History kTable{{0.0, 1.0}, {0.0, 1.0}};

TEST(History, GoesOnAlongARampAfterItsEnd) {
  const History ramp = History::ramp();
  for (const double time : {0.0, 0.25, 1.0, 2.0, 3.0, 1e6}) {
    EXPECT_EQ(ramp.at(time), time);
    EXPECT_EQ(ramp.slope_at(time), 1.0);
  }
}

TEST(History, OfATableHoldsItsLastFactorWhateverItsNumbersAre) {
  for (const History& history : {kTable, History::turning_points({1.0})}) {
    EXPECT_EQ(history.at(0.5), 0.5);
    EXPECT_EQ(history.slope_at(0.5), 1.0);
    for (const double time : {1.0, 2.0, 3.0}) {
      EXPECT_EQ(history.at(time), 1.0);
      EXPECT_EQ(history.slope_at(time), 0.0);
    }
  }
  EXPECT_NE(kTable, History::ramp());
  EXPECT_EQ(kTable, History{});
}

TEST(History, GoesOnAlongTheLastOfSeveralLines) {
  // 2 at 1 s, 3 at 3 s, so half a unit a second from there on.
  const History history{{0.0, 1.0, 3.0}, {0.0, 2.0, 3.0}, true};
  EXPECT_EQ(history.at(0.5), 1.0);
  EXPECT_EQ(history.at(2.0), 2.5);
  EXPECT_EQ(history.at(3.0), 3.0);
  EXPECT_EQ(history.at(5.0), 4.0);
  EXPECT_EQ(history.slope_at(0.5), 2.0);
  EXPECT_EQ(history.slope_at(7.0), 0.5);
}

/// A path that snaps through may need a load against the one that is given: a factor below 0.
TEST(History, GoesOnBeforeItsBeginningToo) {
  EXPECT_EQ(History::ramp().at(-0.5), -0.5);
  EXPECT_EQ(kTable.at(-0.5), 0.0);
  EXPECT_EQ(kTable.slope_at(-0.5), 0.0);
  const History history{{1.0, 2.0}, {3.0, 5.0}, true};
  EXPECT_EQ(history.at(0.5), 2.0);
  EXPECT_EQ(history.slope_at(0.5), 2.0);
  EXPECT_EQ(history.at(4.0), 9.0);
}

TEST(History, OfOnePointIsConstant) {
  EXPECT_EQ(History::constant().at(0.0), 1.0);
  EXPECT_EQ(History::constant().at(9.0), 1.0);
  EXPECT_EQ(History::constant().slope_at(0.0), 0.0);
}

TEST(History, OfASineIsThatWithin2e8) {
  const History sine = History::sine(0.4, 2.25, 0.3, 0.5);
  const double rate = 2.0 * std::numbers::pi / 0.4;
  for (double time = 0.0; time < 0.9; time += 0.000777) {
    EXPECT_NEAR(sine.at(time), 0.5 + std::sin(rate * time + 0.3), 2e-8);
    EXPECT_NEAR(sine.slope_at(time), rate * std::cos(rate * time + 0.3), 2e-4);
  }
  EXPECT_NEAR(sine.end(), 0.9, 1e-15);
  EXPECT_NEAR(sine.at(5.0), 0.5 + std::sin(4.5 * std::numbers::pi + 0.3), 1e-12);
  EXPECT_EQ(sine.corners(), (std::vector<double>{0.0, sine.end()}));
}

TEST(History, OfASineThatHardlyBeginsHasTwoPoints) {
  const History sine = History::sine(1.0, 1e-12, 0.0, 0.5);
  ASSERT_EQ(sine.time.size(), 2U);
  EXPECT_EQ(sine.at(0.0), 0.5);
  EXPECT_NEAR(sine.at(1.0), 0.5, 1e-11);
}

TEST(History, OfASineTurnsAtItsPeaks) {
  const auto reversals = History::sine(1.0, 2.0, 0.3).reversals();
  ASSERT_EQ(reversals.size(), 4U);
  const double first = 0.25 - 0.3 / (2.0 * std::numbers::pi);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(reversals[k], first + 0.5 * static_cast<double>(k), 1e-6);
  }
  // The peaks are points of the table.
  EXPECT_EQ(History::sine(1.0, 3.0).reversals().size(), 6U);
}

/// Any cubic is its own spline, whatever the rows; of three points a parabola, of two a line.
TEST(History, SplineOfACubicIsThatCubic) {
  const std::vector<double> rows{0.1, 0.15, 0.4, 0.45, 0.9, 1.4, 1.5};
  const auto through = [&](std::size_t count, auto&& function) {
    std::vector<double> time(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(count));
    std::vector<double> factor;
    for (const double t : time) factor.push_back(function(t));
    History spline = History::spline(time, factor);
    for (double t = time.front(); t < time.back(); t += 0.0173) {
      EXPECT_NEAR(spline.at(t), function(t), 1e-13) << count << " at " << t;
    }
    return spline;
  };
  const auto cubic = [](double t) { return 2.0 - t + 3.0 * t * t - 4.0 * t * t * t; };
  for (std::size_t count = 4; count <= rows.size(); ++count) {
    const History spline = through(count, cubic);
    EXPECT_NEAR(spline.slope.front(), -1.0 + 0.6 - 0.12, 1e-12);
    EXPECT_NEAR(spline.curvature_at(0.3), 6.0 - 24.0 * 0.3, 1e-11);
  }
  through(3, [](double t) { return 1.0 + t - 5.0 * t * t; });
  through(2, [](double t) { return 1.0 - 7.0 * t; });
}

/// Neither slope nor curvature jumps at a row, and the error falls as the fourth power.
TEST(History, SplineIsSmoothAndOfFourthOrder) {
  const auto sampled = [](int rows) {
    std::vector<double> time, factor;
    for (int i = 0; i < rows; ++i) {
      const double u = static_cast<double>(i) / (rows - 1);
      time.push_back(2.0 * u * (0.6 + 0.4 * u));
      factor.push_back(std::sin(3.0 * time.back() + 0.4));
    }
    return History::spline(time, factor);
  };
  const auto error = [&](int rows) {
    const History spline = sampled(rows);
    double off = 0.0;
    for (double t = 0.0; t <= 2.0; t += 0.00173) {
      off = std::max(off, std::fabs(spline.at(t) - std::sin(3.0 * t + 0.4)));
    }
    return off;
  };
  EXPECT_NEAR(std::log2(error(81) / error(161)), 4.0, 0.3);
  const History spline = sampled(15);
  constexpr double kNear = 1e-9;
  for (std::size_t i = 1; i + 1 < spline.time.size(); ++i) {
    const double t = spline.time[i];
    EXPECT_NEAR(spline.slope_at(t - kNear), spline.slope_at(t + kNear), 1e-6) << i;
    EXPECT_NEAR(spline.curvature_at(t - kNear), spline.curvature_at(t + kNear), 1e-6) << i;
  }
  EXPECT_EQ(spline.corners(), (std::vector<double>{spline.time.front(), spline.time.back()}));
}

TEST(History, OfASmoothStepHasNoCornerInside) {
  const History step = History::smooth_step(1.0, 3.0);
  EXPECT_EQ(step.at(0.5), 0.0);
  EXPECT_EQ(step.at(2.0), 0.5);
  EXPECT_DOUBLE_EQ(step.at(1.5), 3.0 / 16.0 - 2.0 / 64.0);
  EXPECT_EQ(step.slope_at(1.0), 0.0);
  EXPECT_DOUBLE_EQ(step.slope_at(2.0), 0.75);
  EXPECT_EQ(step.at(4.0), 1.0);
  EXPECT_TRUE(step.reversals().empty());
}

TEST(History, KnowsItsSlopesOnBothSidesOfATime) {
  const auto expect = [](const History& history, double time, double before, double after,
                         bool ends = false) {
    const History::SlopeChange slope = history.slopes_about(time, 1e-9);
    EXPECT_NEAR(slope.before, before, 1e-12) << time;
    EXPECT_NEAR(slope.after, after, 1e-12) << time;
    EXPECT_EQ(slope.ends, ends) << time;
  };
  const History table{{1.0, 2.0, 4.0}, {0.0, 3.0, 2.0}};
  expect(table, 0.5, 0.0, 0.0);
  expect(table, 1.0, 0.0, 3.0);
  expect(table, 1.0 - 5e-10, 0.0, 3.0);
  expect(table, 1.5, 3.0, 3.0);
  expect(table, 2.0 + 5e-10, 3.0, -0.5);
  expect(table, 4.0, -0.5, 0.0);
  expect(table, 5.0, 0.0, 0.0);
  expect(History::ramp(), 0.0, 1.0, 1.0);
  expect(History::ramp(), 1.0, 1.0, 1.0);
  expect(History::constant(), 0.0, 0.0, 0.0);
  const History smooth = History::smooth_step(1.0, 2.0);
  expect(smooth, 1.0, 0.0, 0.0, true);
  expect(smooth, 1.5, 1.5, 1.5);
  const History sine = History::sine(1.0, 2.0);
  expect(sine, 1.0, 2.0 * std::numbers::pi, 2.0 * std::numbers::pi);
  expect(sine, 2.0, 2.0 * std::numbers::pi, 0.0, true);
}

}  // namespace
}  // namespace plastica
