#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "calibrate/fit/scene_fit.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/support/normal.hpp"

// What noise and segments do to the parameters of a fit through a beam.

namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::measured;
using testing::Normal;
using testing::Truth;

TEST(SceneFitReference, GivesErrorsThatTheNoiseOfFiftyCurvesHas) {
  constexpr int kCurves = 50;
  constexpr double kNoise = 5.0;  // [N], 0.2 % of the largest force
  const plastica::Setup setup = bend_test(10);
  const SceneTarget exact = measured(setup);
  const SceneFitOptions options{.parameters = all_three(), .starts = 1, .segments_error = false};
  const double strain = fit_scene(setup, exact, options).parameters[2].value;
  const std::array<double, 3> truth{Truth{}.youngs_modulus, Truth{}.yield_stress, strain};
  std::array<double, 3> sum{};
  std::array<double, 3> squares{};
  double noise = 0.0;
  for (int curve = 0; curve < kCurves; ++curve) {
    Normal normal(1000 + static_cast<std::uint64_t>(curve));
    SceneTarget target = exact;
    for (double& force : target.ordinate) force += kNoise * normal.draw();
    const SceneFitResult fit = fit_scene(setup, target, options);
    ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
    noise += fit.targets[0].noise / kCurves;
    for (std::size_t i = 0; i < 3; ++i) {
      const double z = (fit.parameters[i].value - truth[i]) / fit.parameters[i].standard_error;
      sum[i] += z;
      squares[i] += z * z;
    }
  }
  // 61 samples: the mean noise is known to 1.3 %.
  EXPECT_NEAR(noise, kNoise, 3.0 * 0.013 * kNoise);
  for (std::size_t i = 0; i < 3; ++i) {
    // Three standard deviations of the mean and of the mean square of 50 normal numbers.
    EXPECT_LT(std::fabs(sum[i] / kCurves), 3.0 / std::sqrt(kCurves)) << i;
    EXPECT_NEAR(squares[i] / kCurves, 1.0, 3.0 * std::sqrt(2.0 / kCurves)) << i;
  }
}

TEST(SceneFitReference, MovesItsParametersWithTheSquareOfTheSegmentLength) {
  // Measured: E 2.5, 0.70, 0.18, 0.046 % too large; the yield stress 3.1, 0.77, 0.19, 0.048 %; the
  // break strain 6.8, 1.7, 0.40, 0.093 % too small. The stiffness of 5 segments is not yet in line.
  const SceneTarget target = measured(bend_test(640));
  const SceneFitOptions options{.parameters = all_three(), .starts = 1, .segments_error = false};
  const SceneFitResult finest = fit_scene(bend_test(640), target, options);
  std::array<double, 3> before{};
  for (const int segments : {5, 10, 20, 40}) {
    const SceneFitResult fit = fit_scene(bend_test(segments), target, options);
    ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
    for (std::size_t i = 0; i < 3; ++i) {
      const double off = fit.parameters[i].value / finest.parameters[i].value - 1.0;
      if (segments > 5) {
        const double order = std::log2(before[i] / off);
        EXPECT_GT(order, segments == 10 ? 1.8 : 1.9) << fit.parameters[i].path << segments;
        EXPECT_LT(order, 2.2) << fit.parameters[i].path << segments;
      }
      before[i] = off;
    }
  }
}

TEST(SceneFitReference, FindsTheSpecimenOfTheShippedCurve) {
  const plastica::Setup setup = bend_test(160);
  SceneTargetSource source;
  source.file = std::string(PLASTICA_SOURCE_DIR) + "/data/targets/bend_test.csv";
  source.abscissa.column = "Displacement";
  source.ordinate.column = "Force";
  SceneTarget probes = measured(setup);
  probes.broke.reset();
  const SceneTarget target = read_scene_target(source, setup.scene, probes);
  ASSERT_TRUE(target.broke);
  const SceneFitResult fit =
      fit_scene(setup, target, {.parameters = all_three(), .starts = 1, .segments_error = false});
  ASSERT_EQ(fit.status, FitStatus::Fitted) << fit.reason;
  EXPECT_NEAR(fit.targets[0].noise, 5.0, 1.0);
  const std::array<double, 3> truth{205e9, 380e6, 0.02};
  for (std::size_t i = 0; i < 3; ++i) {
    const FittedParameter& p = fit.parameters[i];
    // 160 segments are 3e-5 off, a tenth of the errors.
    EXPECT_NEAR(p.value, truth[i], 3.0 * p.standard_error) << p.path;
    EXPECT_LT(p.standard_error, 0.01 * truth[i]) << p.path;
  }
}

}  // namespace
}  // namespace plastica::calibrate
