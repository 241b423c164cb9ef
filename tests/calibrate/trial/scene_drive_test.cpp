#include "calibrate/trial/scene_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibrate/trial/scene_model.hpp"
#include "tests/calibrate/fit/bent_bar.hpp"

namespace plastica::calibrate {
namespace {

using testing::bend_test;

/// The bar's end pushed down and up again.
SceneTarget to_and_fro() {
  SceneTarget target;
  target.name = "cyclic";
  target.kind = Abscissa::Support;
  target.driven = 1;
  target.ordinate_probe = "force";
  target.ordinate_factor = -1.0;
  target.abscissa = {0.0, 0.02, 0.05, 0.03, -0.01, 0.04};
  target.ordinate.assign(target.abscissa.size(), 0.0);
  return target;
}

TEST(SceneDrive, FollowsWhatWasMeasuredUpAndDown) {
  SceneTarget target = to_and_fro();
  const plastica::Setup setup = driven_setup(bend_test(6), target);
  // Down by 80 mm at a factor of 1.
  EXPECT_EQ(setup.scene.supports[1].history.factor,
            (std::vector<double>{0.0, 0.0, 0.25, 0.625, 0.375, -0.125, 0.5}));
  EXPECT_EQ(setup.solver.steps, 6);
  const Response response = simulate(setup.scene, setup.solver);
  ASSERT_EQ(response.status, Status::Completed);
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    EXPECT_NEAR(response.probes[0][i + 1], -target.abscissa[i], 1e-10) << i;
  }
  const SceneModel model(bend_test(6), target, {});
  const SceneCurve curve = model.run({}, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  for (std::size_t i = 0; i < target.abscissa.size(); ++i) {
    EXPECT_EQ(curve.ordinate[i], -response.probes[1][i + 1]) << i;
  }
  // It came back with a permanent bend: the force changes its sign before the way does.
  EXPECT_LT(curve.ordinate[4], curve.ordinate[3]);
  EXPECT_GT(curve.strain.at, 0.0);
}

TEST(SceneDrive, HasASampleWhereTheTargetBroke) {
  SceneTarget target = to_and_fro();
  target.abscissa = {0.02, 0.04, 0.05};
  target.ordinate = {0.0, 0.0, 0.0};
  target.broke = SceneBreak{0.055, 0.005};
  const SceneCurve curve = SceneModel(bend_test(6), target, {}).run({}, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  EXPECT_GT(curve.strain.before, 0.0);
  EXPECT_GT(curve.strain.after, curve.strain.before);
  EXPECT_NEAR(curve.strain.at, 0.5 * (curve.strain.before + curve.strain.after), 1e-12);
}

TEST(SceneDrive, StretchesACouponByItsMeasuredStrain) {
  plastica::Setup setup;
  setup.scene.drive.strain = {0.001};
  setup.scene.material.youngs_modulus = 200e9;
  setup.scene.material.yield_stress = 300e6;
  SceneTarget target;
  target.kind = Abscissa::Strain;
  target.ordinate_probe = "stress";
  target.abscissa = {0.0, 0.001, 0.01, 0.009};
  target.ordinate.assign(4, 0.0);
  const SceneCurve curve = SceneModel(setup, target, {}).run({}, 1).front();
  ASSERT_TRUE(curve.usable) << curve.reason;
  EXPECT_NEAR(curve.ordinate[1], 200e6, 1.0);
  EXPECT_NEAR(curve.ordinate[2], 300e6, 1.0);
  EXPECT_NEAR(curve.ordinate[3], 100e6, 1.0);
  EXPECT_NEAR(curve.strain.at, 0.01 - 300e6 / 200e9, 1e-12);
}

template <class Change>
std::string drive_refusal(const Change& change) {
  plastica::Setup setup = bend_test(6);
  SceneTarget target = to_and_fro();
  change(setup, target);
  try {
    (void)driven_setup(setup, target);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneDrive, RefusesWhatCannotFollow) {
  EXPECT_EQ(drive_refusal([](auto&, auto& target) { target.driven = 2; }),
            "abscissa.drive = support[3]: the scene has 2 of them");
  EXPECT_EQ(
      drive_refusal([](auto&, auto& target) { target.driven = 0; }),
      "abscissa.drive = support[1]: must be moved by a translation or by a rotation, to follow a "
      "number");
  EXPECT_EQ(drive_refusal([](auto&, auto& target) { target.kind = Abscissa::Load; }),
            "abscissa.drive = load[2]: the scene has none");
  EXPECT_EQ(drive_refusal([](auto& setup, auto&) {
              setup.scene.loads.push_back({.force = {0.0, 1.0, 0.0}});
            }),
            "load[1].history: must be constant: the scene is driven by what was measured, and the "
            "rest is there from the first");
  EXPECT_EQ(drive_refusal([](auto& setup, auto&) { setup.solver.analysis = Analysis::Dynamics; }),
            "abscissa.drive: is followed at rest: the curve of a motion is compared over its time");
}

}  // namespace
}  // namespace plastica::calibrate
