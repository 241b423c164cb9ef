#include "calibrate/report/quantile_figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "calibrate/report/interval_figures.hpp"
#include "plastica/theory/statistics.hpp"
#include "tests/calibrate/report/records.hpp"
#include "tests/support/message.hpp"

// What pictures of residuals and of pairs compute.

namespace plastica::calibrate::report {
namespace {

using plastica::testing::message_of;

/// The points of a panel, and its band: (x, low, high).
const auto& points_of(const FigurePanel& panel) { return panel.curves[2].points; }
const auto& band_of(const FigurePanel& panel) { return panel.curves[0].points; }

TEST(QuantilePanel, HasNormalResidualsOnTheLine) {
  std::vector<double> residuals;
  for (int i = 1; i <= 50; ++i) {
    residuals.push_back(2.5 * theory::normal_quantile((i - 0.375) / 50.25));
  }
  std::shuffle(residuals.begin(), residuals.end(), std::mt19937(1));
  const FigurePanel panel = quantile_panel(residuals, 2.5);
  for (const auto& point : points_of(panel)) {
    EXPECT_NEAR(point[1], point[0], 1e-12);
  }
}

TEST(QuantilePanel, HasBlomsPlacesAndTheErrorOfAMedian) {
  const FigurePanel panel = quantile_panel({3.0, 1.0, 2.0}, 1.0);
  ASSERT_EQ(points_of(panel).size(), 3U);
  EXPECT_EQ(points_of(panel)[0][1], 1.0);
  EXPECT_EQ(points_of(panel)[2][1], 3.0);
  // 0.625/3.25 of a normal distribution lie below, by a table.
  EXPECT_NEAR(points_of(panel)[0][0], -0.8694, 1e-4);
  EXPECT_EQ(points_of(panel)[1][0], 0.0);
  // A median's standard error is sqrt(pi/2n).
  const double half = 1.959964 * std::sqrt(std::acos(-1.0) / 6.0);
  EXPECT_NEAR(band_of(panel)[1][2], half, 1e-5);
  EXPECT_NEAR(band_of(panel)[1][1], -half, 1e-5);
}

TEST(QuantilePanel, HasNineteenOfTwentyInItsBandAndNoUniformTails) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(-std::sqrt(3.0), std::sqrt(3.0));
  constexpr std::size_t kSamples = 200;
  constexpr int kTimes = 1000;
  int within = 0;
  int uniform_within = 0;
  for (int k = 0; k < kTimes; ++k) {
    std::vector<double> residuals(kSamples);
    std::ranges::generate(residuals, [&] { return normal(random); });
    const FigurePanel panel = quantile_panel(residuals, 1.0);
    const auto holds = [](const FigurePanel& of, std::size_t i) {
      return points_of(of)[i][1] > band_of(of)[i][1] && points_of(of)[i][1] < band_of(of)[i][2];
    };
    within += holds(panel, kSamples / 4) ? 1 : 0;
    std::ranges::generate(residuals, [&] { return uniform(random); });
    uniform_within += holds(quantile_panel(residuals, 1.0), kSamples - 1) ? 1 : 0;
  }
  // Four standard deviations of a count of 1000.
  EXPECT_NEAR(within, 950, 28);
  EXPECT_LT(uniform_within, 50);
}

TEST(QuantilesFigure, RefusesWhatWasNotFitted) {
  FitRecord record = testing::fitted_record();
  EXPECT_EQ(quantiles_figure(record).panels.size(), 1U);
  record.result.noise.reset();
  record.result.misfit_rms *= 3.0;  // weighed along a path it is another number
  const FigurePanel panel = quantiles_figure(record).panels[0];
  double squares = 0.0;
  for (const auto& point : points_of(panel)) squares += point[1] * point[1];
  EXPECT_NEAR(squares, static_cast<double>(points_of(panel).size()), 1e-9);
  record.result.fitted = record.target.corrected;
  EXPECT_EQ(message_of([&] { quantiles_figure(record); }),
            "--what = quantiles: bar-01 is fitted without a misfit");
  record.result.status = FitStatus::Failed;
  EXPECT_EQ(message_of([&] { quantiles_figure(record); }),
            "--what = quantiles: bar-01 was not fitted");
}

/// Every point of the ellipses of a pair whose second value is `slope` times the first, and more.
void expect_ellipses(double slope) {
  FitIntervals all;
  all.residuals.resamples = 4;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      all.residuals.values.push_back(3.0 + x);
      all.residuals.values.push_back(5.0 + y + slope * x);
    }
  }
  all.residuals.intervals.assign(2, {1.0, 0.0, 10.0});
  ShownIntervals shown;
  shown.parameters = {{"a", Dimension::None, 3.0}, {"b", Dimension::None, 5.0}};
  shown.intervals = &all;
  const FigurePanel pair = bootstrap_figure(shown).panels.back();
  std::vector<double> radii;
  for (const auto& curve : pair.curves) {
    if (curve.points.size() < 100) continue;
    const auto radius = [&](const std::vector<double>& point) {
      const double x = point[0] - 3.0;
      const double y = point[1] - 5.0 - slope * x;
      return std::hypot(x, y);
    };
    radii.push_back(radius(curve.points.front()));
    for (const auto& point : curve.points) EXPECT_NEAR(radius(point), radii.back(), 1e-12);
  }
  // Variance 4/3; chi^2 of two degrees of freedom, by a table.
  ASSERT_EQ(radii.size(), 2U);
  EXPECT_NEAR(radii[0] * radii[0], 1.3863 * 4.0 / 3.0, 1e-4);
  EXPECT_NEAR(radii[1] * radii[1], 5.9915 * 4.0 / 3.0, 1e-4);
}

TEST(PairPanel, HasTheEllipsesOfItsCovariance) {
  expect_ellipses(0.0);
  expect_ellipses(2.0);
  expect_ellipses(-0.7);
}

}  // namespace
}  // namespace plastica::calibrate::report
