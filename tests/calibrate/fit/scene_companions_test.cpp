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

/// The bar pushed by a force up to 2.3 mm, measured up to 4.
struct Pushed {
  plastica::Setup setup = bend_test(5);
  SceneTarget target;

  explicit Pushed(double force) {
    setup.scene.supports.pop_back();
    setup.scene.loads = {{.at = Place::end(), .force = {0.0, -force, 0.0}}};
    setup.scene.probes[1] = {"force", ProbeQuantity::LoadFactor};
    target.name = "pushed";
    target.abscissa_probe = "displacement";
    target.ordinate_probe = "force";
    target.abscissa_factor = -1.0;
    for (int i = 0; i <= 40; ++i) target.abscissa.push_back(1e-4 * i);
    target.ordinate.assign(target.abscissa.size(), 0.0);
  }
};

TEST(SceneCompanions, GoOnWithTheirLeadWhereItsRampEndsTooEarly) {
  const Pushed pushed(300.0);
  const SceneModel model = model_of(pushed.setup, pushed.target);
  const std::vector<double> points = points_about(250e9, 355e6);
  const auto alone = model.run(points, 5);
  const auto beside = model.run(points, 5, 1, nullptr, kBesideTheFirst);
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(beside[i].usable) << beside[i].reason;
    EXPECT_TRUE(beside[i].is_extended);
    EXPECT_NEAR(beside[i].ordinate.back(), alone[i].ordinate.back(), 1e-8);
  }
}

/// A lead that is lost beyond what was measured has a curve all the same, as its companions have.
TEST(SceneCompanions, RunAloneWhereTheLeadIsLostBeyondWhatWasMeasured) {
  Pushed pushed(450.0);
  pushed.setup.solver.steps = 3;
  pushed.setup.solver.max_iterations = 2;
  pushed.setup.solver.smallest_step = 1.0;
  const SceneModel model = model_of(pushed.setup, pushed.target);
  const std::vector<double> points = points_about(250e9, 355e6);
  const auto alone = model.run(points, 5);
  const auto beside = model.run(points, 5, 1, nullptr, kBesideTheFirst);
  for (std::size_t i = 0; i < 5; ++i) {
    ASSERT_TRUE(beside[i].usable) << beside[i].reason;
    EXPECT_TRUE(beside[i].was_run);
    EXPECT_EQ(beside[i].ordinate, alone[i].ordinate);
  }
  EXPECT_NE(beside[1].ordinate, beside[0].ordinate);
}

}  // namespace
}  // namespace plastica::calibrate
