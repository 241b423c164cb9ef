#include "sweeps/compare/unrefined.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sweeps/compare/convergence.hpp"
#include "sweeps/trade/setting.hpp"
#include "tests/support/has.hpp"
#include "tests/sweeps/made_sweep.hpp"

// Cases that agree because none of them is finer where it matters.

namespace plastica::sweeps {
namespace {

using plastica::testing::has;

constexpr const char* kStart = "not converged: ";

/// Cantilevers of 16, 32 and 64 segments that agree to the last digit.
Made agreeing(const std::string& how) {
  return {segments_axis("[16, 32, 64]") + against(how), {1.0, 1.0, 1.0}};
}

TEST(Unrefined, IsAStretchOfOneSegmentThatIsAllThatBends) {
  for (const char* how : {"finest", "richardson"}) {
    Made made = agreeing(how);
    std::vector<Load>& loads = made.sweep.setup.scene.loads;
    loads[0].at = {0.01, {}};
    const Comparison found = made.compared();
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_FALSE(found.error[i].has_value()) << how;
      EXPECT_EQ(found.reason[i], std::string(kStart) +
                                     "between support[1].at and load[1].at is 1 segment in all "
                                     "cases");
    }
    // With another load beyond it the rest bends, too; and so does what is no support's.
    loads.push_back(loads[0]);
    loads[1].at = Place::end();
    EXPECT_FALSE(has(made.compared().reason[0], kStart)) << made.compared().reason[0];
    loads[0].at = {0.99, {}};
    EXPECT_FALSE(has(made.compared().reason[0], kStart)) << made.compared().reason[0];
  }
}

TEST(Unrefined, IsAStretchOfOneSegmentBetweenSupports) {
  Made made = agreeing("finest");
  Scene& scene = made.sweep.setup.scene;
  scene.supports.push_back({.at = {0.01, {}}, .kind = SupportKind::Roller});
  EXPECT_EQ(
      made.compared().reason[0],
      std::string(kStart) + "between support[1].at and support[2].at is 1 segment in all cases");
  Support soft{.at = {0.01, {}}, .kind = SupportKind::Elastic, .stiffness = {1.0, 1.0, 0.0}};
  std::swap(scene.supports[1], soft);
  EXPECT_FALSE(has(made.compared().reason[0], kStart)) << "a spring holds nothing";
  std::swap(scene.supports[1], soft);
  scene.supports[1].at = {0.3, {}};
  EXPECT_TRUE(made.compared().error[0].has_value()) << made.compared().reason[0];
}

TEST(Unrefined, IsNoOtherStretch) {
  Made made = agreeing("finest");
  Scene& scene = made.sweep.setup.scene;
  scene.loads[0].at = {0.05, {}};  // 1, 2 and 3 segments
  EXPECT_TRUE(made.compared().error[0].has_value()) << made.compared().reason[0];
  EXPECT_TRUE(promised_error(made.record(), 0).has_value());
  scene.loads[0].at = Place::end();
  scene.regions.push_back({{0.97, {}}, {0.98, {}}, scene.section, scene.material});
  EXPECT_TRUE(made.compared().error[0].has_value()) << made.compared().reason[0];
  scene.masses.push_back({.at = {0.5, {}}, .mass = 1.0});
  scene.loads[0].at = {0.49, {}};
  scene.loads[0].to = Place{0.51, {}};
  EXPECT_TRUE(made.compared().error[0].has_value()) << made.compared().reason[0];
}

TEST(Unrefined, IsAProbeOfAJointBesideItsPlace) {
  Made made = agreeing("finest");
  Probe& moment = made.sweep.setup.scene.probes[made.sweep.quantity.probe];
  moment.quantity = ProbeQuantity::Moment;
  moment.at = {0.93, {}};
  EXPECT_FALSE(convergence_of(made.groups[0], made.results, made.compared()).grid.has_value());
  EXPECT_EQ(made.compared().reason[0],
            std::string(kStart) + "tip at 0.93 is of the joint at 0.9375 in the finest cases");
  moment.at = {0.75, {}};
  EXPECT_TRUE(made.compared().error[0].has_value());
  moment.at = {0.7, {}};  // joints at 0.6875 or 0.703125
  EXPECT_TRUE(made.compared().error[0].has_value());
  moment.quantity = ProbeQuantity::Displacement;
  moment.at = {0.93, {}};
  EXPECT_TRUE(made.compared().error[0].has_value()) << "of a point, not of a joint";
}

TEST(Unrefined, IsTheAngleOfAJointThatFallsWithItsLength) {
  for (const auto quantity : {ProbeQuantity::Angle, ProbeQuantity::PlasticAngle}) {
    Made made = agreeing("finest");
    made.sweep.setup.scene.probes[made.sweep.quantity.probe].quantity = quantity;
    EXPECT_TRUE(made.compared().error[0].has_value()) << "a hinge turns by what it turns by";
    for (std::size_t i = 0; i < 3; ++i) {
      made.results[i].value = 1.0 / std::pow(2.0, static_cast<double>(i));
      made.results[i].segments = 16 << i;
    }
    EXPECT_FALSE(made.compared().error[0].has_value());
    EXPECT_TRUE(has(made.compared().reason[0], "which falls with the joint's length"));
    made.sweep.setup.scene.probes[made.sweep.quantity.probe].quantity = ProbeQuantity::Rotation;
    EXPECT_TRUE(made.compared().error[0].has_value());
  }
}

TEST(Unrefined, IsAPeriodThatIsNoLongerThanAFewSteps) {
  Made made("[[axis]]\nfield = 'solver.time_step'\nvalues = ['40 ms', '20 ms', '10 ms']\n" +
                against("finest"),
            {1.0, 1.0, 1.0});
  plastica::Setup& setup = made.sweep.setup;
  setup.solver.analysis = Analysis::Dynamics;
  setup.solver.duration = 0.2;
  setup.solver.steps = 5;
  setup.scene.loads[0].history = History::sine(0.02, 20.0);
  EXPECT_EQ(
      made.compared().reason[0],
      std::string(kStart) + "the finest steps of 0.01 s are 2 in a period of load[1].history");
  setup.scene.loads[0].history = History::sine(0.1, 4.0);
  EXPECT_TRUE(made.compared().error[0].has_value()) << made.compared().reason[0];
}

}  // namespace
}  // namespace plastica::sweeps
