#include <gtest/gtest.h>

#include "tests/lib/model/chain_scenes.hpp"

namespace plastica {
namespace {

using testing::error_of;
using testing::error_of_motion;

TEST(CheckModes, RefusesThemWhereThereIsNoEquilibriumToBeAbout) {
  const std::string rule = ": needs solver.analysis = \"statics\": modes are about an equilibrium";
  EXPECT_EQ(error_of_motion([](Scene&, SolverOptions& o) { o.buckling = 2; }),
            "solver.buckling = 2" + rule);
  EXPECT_EQ(error_of_motion([](Scene&, SolverOptions& o) { o.frequencies = 1; }),
            "solver.frequencies = 1" + rule);
}

TEST(CheckModes, RefusesLoadsWithoutAPotential) {
  const std::string rule = "solver.buckling = 3: is for loads that have a potential: ";
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s.loads[0].follows = true;
              o.buckling = 3;
            }),
            rule + "load[1] follows its segment");
  const auto turned = [](Level level) {
    return error_of([&](Scene& s, SolverOptions& o) {
      s.loads.push_back({.moment = {10.0, 0.0, 0.0}});
      o.level = level;
      o.buckling = 3;
    });
  };
  EXPECT_EQ(turned(Level::Spatial), rule + "load[2] has a moment of a fixed axis in space");
  EXPECT_EQ(turned(Level::Planar), "no error");  // a warning says that it covers the plane alone
}

TEST(CheckModes, RefusesThemOfCouponsOfTwistAndInFloat) {
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s = {};
              s.drive.strain = {0.0, 1e-3};
              o.frequencies = 1;
            }),
            "solver.frequencies = 1: is of a beam: a coupon has no modes");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s.loads[0] = {.moment = {0.0, 0.0, 10.0}};
              o.level = Level::Twist;
              o.buckling = 1;
            }),
            "solver.buckling = 1: needs a level that bends: a beam that is only twisted does not "
            "buckle");
  EXPECT_EQ(error_of([](Scene& s, SolverOptions& o) {
              s.yield_model = YieldModel::PerAxis;
              o.precision = Precision::Float;
              o.frequencies = 1;
            }),
            "solver.frequencies = 1: needs solver.precision = \"double\"");
  EXPECT_EQ(error_of([](Scene&, SolverOptions& o) { o.frequencies = -1; }),
            "solver.frequencies = -1: must be from 0 to 1000");
}

}  // namespace
}  // namespace plastica
