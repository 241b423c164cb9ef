#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/calibrate/fit/bent_bar.hpp"
#include "tests/support/message.hpp"

// Bad input of a fit of a scene: one line each.

namespace plastica::calibrate {
namespace {

using testing::all_three;
using testing::bend_test;
using testing::free_parameter;
using testing::measured;
using testing::message_of;

struct Input {
  Setup setup = bend_test(4);
  SceneTarget target = measured(setup);
  SceneFitOptions options{.parameters = all_three(), .starts = 1};
};

std::string refusal(const std::function<void(Input&)>& change) {
  Input input;
  change(input);
  return message_of([&] { fit_scene(input.setup, input.target, input.options); });
}

TEST(SceneFitErrors, NameTheParameterThatIsWrong) {
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters.clear(); }),
            "fit.parameters: at least one must be free");
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters[0].upper.reset(); }),
            "material.youngs_modulus: needs a lower and an upper bound to be fitted");
  EXPECT_EQ(
      refusal([](Input& in) { in.options.parameters[0].upper = 1e9; }),
      "material.youngs_modulus = [5e+10, 1e+09]: the lower bound must be below the upper one");
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters[0].lower = -1.0; }),
            "material.youngs_modulus = -1: must be above 0 Pa");
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters[1].value = 3e9; }),
            "material.yield_stress = 3e+09: the start must lie between the bounds");
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters[1] = in.options.parameters[0]; }),
            "material.youngs_modulus: is given twice");
  EXPECT_EQ(refusal([](Input& in) {
              in.options.parameters.push_back(free_parameter("beam.segments", 2.0, 9.0));
            }),
            "beam.segments: is no number that a fit could move");
  EXPECT_EQ(
      refusal([](Input& in) { in.options.parameters[0].role = ParameterRole::Tied; }),
      "material.youngs_modulus: must be tied to a parameter of the fit that is not tied itself");
  EXPECT_EQ(refusal([](Input& in) { in.options.parameters[0].role = ParameterRole::Fixed; }),
            "material.youngs_modulus: is fixed and needs a value");
  EXPECT_EQ(refusal([](Input& in) { in.target.broke.reset(); }),
            "material.break_strain: cannot be fitted: the target does not say where it broke");
  EXPECT_EQ(refusal([](Input& in) { in.setup.solver.level = Level::Spatial; }),
            "material.break_strain: is fitted where the beam bends in a plane (solver.level)");
  const auto with_hinge = [](Input& in) {
    in.options.parameters.push_back(free_parameter("rules.hinge_length", 1e-3, 0.1));
  };
  EXPECT_EQ(refusal(with_hinge),
            "rules.hinge_length: cannot be fitted beside material.break_strain: a break tells only "
            "what both make together");
  const auto hinge_alone = [](Input& in) {
    in.options.parameters = {free_parameter("rules.hinge_length", 1e-3, 0.1)};
    in.setup.scene.material.break_strain.reset();
  };
  EXPECT_EQ(
      refusal(hinge_alone),
      "rules.hinge_length: is fitted to where a beam in bending broke, by a break strain that "
      "its scene has or that is fixed");
  EXPECT_EQ(refusal([&](Input& in) {
              hinge_alone(in);
              in.target.broke.reset();
            }),
            "rules.hinge_length: cannot be fitted: the target does not say where it broke");
}

TEST(SceneFitErrors, NameWhatIsWrongWithTargetAndOptions) {
  EXPECT_EQ(refusal([](Input& in) { in.target.abscissa_probe = "tip"; }),
            "abscissa.probe = tip: is not one of the scene's probes: displacement, force");
  EXPECT_EQ(refusal([](Input& in) { in.target.abscissa[5] = 0.0; }),
            "target = bar: must be finite and never go back, and does at sample 5");
  EXPECT_EQ(refusal([](Input& in) { in.target.ordinate.pop_back(); }),
            "target = bar: needs as many ordinates as abscissas, and any");
  EXPECT_EQ(refusal([](Input& in) {
              in.target.abscissa.resize(2);
              in.target.ordinate.resize(2);
            }),
            "target = bar: has no more samples than the fit has parameters");
  EXPECT_EQ(refusal([](Input& in) { in.target.noise = 0.0; }), "noise = 0: must be above 0");
  EXPECT_EQ(refusal([](Input& in) { in.target.ordinate_factor = 0.0; }),
            "factor = 0: must be finite and not 0");
  EXPECT_EQ(refusal([](Input& in) { in.options.evaluations = 0; }),
            "evaluations = 0: must be at least 1");
  EXPECT_EQ(refusal([](Input& in) { in.options.starts = 0; }), "starts = 0: must be at least 1");
  EXPECT_EQ(refusal([](Input& in) { in.options.tolerance = 0.0; }),
            "tolerance = 0: must be above 0");
}

TEST(SceneFitErrors, RefuseScenesThatGiveNoSuchCurve) {
  EXPECT_EQ(refusal([](Input& in) { in.target.abscissa_factor = 1.0; }),
            "abscissa.probe = displacement: the probe displacement must grow along the path "
            "(times 1), and does not at sample 1; a scene whose drive follows what was measured "
            "may turn; if the machine counts the other way: abscissa.factor = -1");
  EXPECT_EQ(
      refusal([](Input& in) {
        in.target.abscissa_where = {"fit.toml", 6};
        in.setup.scene.supports[1].history = History::turning_points({1.0, 0.5});
      }),
      "fit.toml:6: abscissa.probe = displacement: the probe displacement must grow along the path "
      "(times -1), and does not at sample 41; a scene whose drive follows what was measured "
      "may turn");
  EXPECT_EQ(refusal([](Input& in) {
              in.setup = {};
              in.setup.scene.drive.strain = {0.001};
            }),
            "drive.strain: makes the scene a coupon, which follows a measured strain");
}

}  // namespace
}  // namespace plastica::calibrate
