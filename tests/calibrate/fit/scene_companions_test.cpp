#include <gtest/gtest.h>

#include <cmath>

#include "plastica/base/check.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"

/// Curves of points that are run as companions of one beside them.
namespace plastica::calibrate {
namespace {

using testing::bend_test;
using testing::measured;

const std::vector<std::size_t> kBesideTheFirst(5, 0);

/// A point and two steps of each of its values.
std::vector<double> points_about(double modulus, double yield) {
  std::vector<double> points;
  for (const double e : {0.0, 1e-5, -1e-5}) {
    points.insert(points.end(), {modulus * (1.0 + e), yield});
  }
  for (const double e : {1e-5, -1e-5}) {
    points.insert(points.end(), {modulus, yield * (1.0 + e)});
  }
  return points;
}

SceneModel model_of(const plastica::Setup& setup, const SceneTarget& target) {
  return {setup,
          target,
          {&find_field("material.youngs_modulus"), &find_field("material.yield_stress")}};
}

TEST(SceneCompanions, HaveTheCurvesOfRunsOfTheirOwnInAnyNumberOfThreads) {
  const plastica::Setup setup = bend_test(8);
  const SceneModel model = model_of(setup, measured(setup));
  const std::vector<double> points = points_about(205e9, 380e6);
  const auto alone = model.run(points, 5);
  const auto beside = model.run(points, 5, 1, nullptr, kBesideTheFirst);
  EXPECT_EQ(beside[0].ordinate, alone[0].ordinate);
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(beside[i].usable) << beside[i].reason;
    for (std::size_t k = 0; k < alone[i].ordinate.size(); ++k) {
      EXPECT_NEAR(beside[i].ordinate[k], alone[i].ordinate[k], 1e-8 * alone[i].ordinate.back());
    }
    EXPECT_NEAR(beside[i].strain.at, alone[i].strain.at, 1e-8);
  }
  EXPECT_NE(beside[1].ordinate, beside[0].ordinate);
  for (const int threads : {2, 4, 7}) {
    const auto dealt = model.run(points, 5, threads, nullptr, kBesideTheFirst);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(dealt[i].ordinate, beside[i].ordinate) << threads;
      EXPECT_EQ(dealt[i].segment_iterations, beside[i].segment_iterations) << threads;
    }
  }
}

TEST(SceneCompanions, AreNotRunBesideALeadThatIsNot) {
  const plastica::Setup setup = bend_test(6);
  const SceneModel model = model_of(setup, measured(setup));
  std::vector<double> points = points_about(205e9, 380e6);
  points[0] = -1.0;
  for (const int threads : {1, 3}) {
    const auto curves = model.run(points, 5, threads, nullptr, kBesideTheFirst);
    EXPECT_TRUE(curves[0].was_run);
    EXPECT_NE(curves[0].reason, "");
    for (std::size_t i = 1; i < 5; ++i) {
      EXPECT_FALSE(curves[i].usable);
      EXPECT_FALSE(curves[i].was_run);
      EXPECT_EQ(curves[i].reason, curves[0].reason);
    }
  }
}

/// The same points as runs of their own, and beside the first.
struct Both {
  std::vector<SceneCurve> alone, beside;

  explicit Both(const plastica::Setup& setup) {
    const SceneModel model = model_of(setup, testing::pushed());
    const std::vector<double> points = points_about(250e9, 355e6);
    alone = model.run(points, 5);
    beside = model.run(points, 5, 1, nullptr, kBesideTheFirst);
  }
};

/// The scene pushes up to 2.3 mm, and 4 were measured.
TEST(SceneCompanions, GoOnWithTheirLeadWhereItsRampEndsTooEarly) {
  const Both both(testing::pushed_bar(300.0));
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(both.beside[i].usable) << both.beside[i].reason;
    EXPECT_TRUE(both.beside[i].is_extended);
    EXPECT_NEAR(both.beside[i].ordinate.back(), both.alone[i].ordinate.back(), 1e-8);
  }
}

/// A lead that is lost beyond what was measured has a curve all the same, as its companions have.
TEST(SceneCompanions, RunAloneWhereTheLeadIsLostBeyondWhatWasMeasured) {
  plastica::Setup setup = testing::pushed_bar(450.0);
  setup.solver.steps = 3;
  setup.solver.max_iterations = 2;
  setup.solver.smallest_step = 1.0;
  const Both both(setup);
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(both.beside[i].usable) << both.beside[i].reason;
    EXPECT_TRUE(both.beside[i].was_run);
    EXPECT_EQ(both.beside[i].ordinate, both.alone[i].ordinate);
  }
  EXPECT_NE(both.beside[1].ordinate, both.beside[0].ordinate);
}

}  // namespace
}  // namespace plastica::calibrate
