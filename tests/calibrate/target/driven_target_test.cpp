#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "calibrate/target/make.hpp"
#include "calibrate/target/samples.hpp"
#include "tests/calibrate/target/scene_target_file.hpp"

// Noise of an abscissa that a scene or a coupon's model follows to and fro.

namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::SceneTargetFile;

// A hold is not driven to the sample that noise took furthest, nor a start.
TEST_F(SceneTargetFile, IsNotDrivenToThePeakOfAHoldsNoise) {
  constexpr double kNoise = 0.1;  // mm
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal(0.0, kNoise);
  std::string text = "Displacement (mm),Force (N)\n";
  const auto add = [&](double x) {
    text += std::to_string(x + normal(random)) + ',' + std::to_string(50.0 * x) + '\n';
  };
  for (int i = 0; i < 100; ++i) add(0.0);
  for (int i = 0; i < 300; ++i) add(0.1 * i);
  for (int i = 0; i < 300; ++i) add(30.0);
  for (int i = 0; i < 80; ++i) add(30.0 - 0.1 * i);
  SceneTargetSource from = source(text);
  from.reversal_tolerance = 8e-3 * kNoise;
  SceneTarget probes;
  probes.kind = Abscissa::Support;
  probes.driven = 1;
  probes.ordinate_probe = "force";
  const SceneTarget mended = read_scene_target(from, bend_test(4).scene, probes);
  const auto [low, high] = std::ranges::minmax(mended.abscissa);
  EXPECT_NEAR(high, 30e-3, 0.5e-3 * kNoise);
  EXPECT_GT(low, -1.5e-3 * kNoise);
}

// Small cycles are of the test, however few samples they have.
TEST_F(SceneTargetFile, IsNotToldThatItsCyclesAreNoise) {
  for (const double samples : {4.0, 8.0, 12.0}) {
    std::string text = "Displacement (mm),Force (N)\n";
    const auto add = [&](double x) {
      text += std::to_string(x) + ',' + std::to_string(50.0 * x) + '\n';
    };
    for (int i = 0; i < 50 * static_cast<int>(samples); ++i) {
      add(0.3 * std::sin(2.0 * 3.14159265358979 * i / samples + 0.3));
    }
    for (int i = 0; i < 100; ++i) add(0.6 * i);
    EXPECT_TRUE(read_driven(text).warnings.empty()) << samples;
  }
}

// A scene that follows noise unloads at each step back, and yields at each peak.
TEST_F(SceneTargetFile, IsToldThatItsNoiseWouldBeFollowed) {
  const auto path = [](double noise) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::string text = "Displacement (mm),Force (N)\n";
    for (int i = 0; i < 900; ++i) {  // up, down and up again
      const double x = i < 300 ? 0.1 * i : i < 600 ? 0.1 * (600 - i) : 0.1 * (i - 600);
      text += std::to_string(x + noise * normal(random)) + ',' + std::to_string(50.0 * x) + '\n';
    }
    return text;
  };
  EXPECT_TRUE(read_driven(path(0.0)).warnings.empty());
  EXPECT_EQ(read_driven(path(0.8)).warnings.size(), 1U);
  const SceneTarget noisy = read_driven(path(0.1));
  ASSERT_EQ(noisy.warnings.size(), 1U);
  EXPECT_TRUE(
      noisy.warnings[0].starts_with("the abscissa runs to and fro by its noise of 0.0001 m"))
      << noisy.warnings[0];
  EXPECT_EQ(noisy.abscissa.size(), 900U);

  SceneTargetSource from = source(path(0.1));
  from.reversal_tolerance = 1e-3;
  SceneTarget probes;
  probes.kind = Abscissa::Support;
  probes.driven = 1;
  probes.ordinate_probe = "force";
  const SceneTarget mended = read_scene_target(from, bend_test(4).scene, probes);
  EXPECT_TRUE(mended.warnings.empty());
  int turns = 0;
  double shift = 0.0;
  for (std::size_t i = 0; i < mended.abscissa.size(); ++i) {
    shift += mended.abscissa[i] - mended.ordinate[i] / 50e3;
    if (i < 2) continue;
    const double before = mended.abscissa[i - 1] - mended.abscissa[i - 2];
    turns += before * (mended.abscissa[i] - mended.abscissa[i - 1]) < 0.0 ? 1 : 0;
  }
  EXPECT_EQ(turns, 2);
  EXPECT_NEAR(shift / static_cast<double>(mended.abscissa.size()), 0.0, 0.15e-4);
}

// The model of a cyclic coupon follows its strain as a scene does.
TEST(DrivenTarget, OfACyclicCouponIsToldThatItsNoiseIsFollowed) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (const double noise : {0.0, 1e-4, 4e-4}) {
    Curve curve;
    double plastic = 0.0;
    for (int i = 0; i <= 1000; ++i) {  // 0, 2, -2, 2, -2, 0 %
      const double part = i / 1000.0 * 8.0;
      const double strain =
          0.02 * (part < 1.0   ? part
                  : part > 7.0 ? part - 8.0
                               : std::abs(std::fmod(part - 1.0, 4.0) - 2.0) - 1.0);
      const double trial = 200e9 * (strain - plastic);
      const double stress = std::clamp(trial, -300e6, 300e6);
      plastic += (trial - stress) / 200e9;
      curve.strain.push_back(strain + noise * normal(random));
      curve.stress.push_back(stress + 1e6 * normal(random));
    }
    TargetOptions options;
    options.loading = Loading::Cyclic;
    const Target target = make_target("cycles", curve, options);
    const auto told = std::ranges::count_if(target.warnings, [](const std::string& warning) {
      return warning.starts_with("the strain runs to and fro by its noise of ");
    });
    EXPECT_EQ(told, noise > 0.0 ? 1 : 0) << noise;
    EXPECT_EQ(target.corrected.size(), curve.size()) << noise;
  }
}

}  // namespace
}  // namespace plastica::calibrate
