#include "plastica/run/section_warnings.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/lib/run/warnings_of.hpp"

namespace plastica {
namespace {

using testing::cantilever;

/// (Z/W - 1) sigma_y/E of a rectangle is half of the elastic strain.
TEST(SceneWarnings, SayThatABreakLimitNearTheElasticStrainIsOfTheBendThatStays) {
  const auto with = [](double limit, YieldModel yields, YieldCap cap) {
    return warns(warnings_of([&](Scene& s) {
                   s.material.youngs_modulus = 200e9;
                   s.material.yield_stress = 300e6;
                   s.material.break_strain = limit;
                   s.yield_model = yields;
                   s.yield_cap = cap;
                 }),
                 "extreme fibre is up to 0.075 % more there");
  };
  EXPECT_TRUE(with(1e-3, YieldModel::Fibre, YieldCap::FirstYield));
  EXPECT_TRUE(with(1.4e-2, YieldModel::PerAxis, YieldCap::FullyPlastic));
  EXPECT_FALSE(with(1.6e-2, YieldModel::Fibre, YieldCap::FirstYield));
  EXPECT_FALSE(with(1e-3, YieldModel::PerAxis, YieldCap::FirstYield)) << "the fibre's own";
}

/// Of a rectangle the rate adds 2P/(2P + 1) of what it adds to the outermost fibre.
TEST(SceneWarnings, SayThatAWholeSectionTakesTheRateOfItsOutermostFibre) {
  const auto with = [](const RateDependence& rate, YieldModel yields) {
    return warnings_of([&](Scene& s) {
      s.material.rate = rate;
      s.yield_model = yields;
      s.yield_cap = YieldCap::FullyPlastic;
    });
  };
  const std::string words = "take the strain rate of the outermost fibre";
  const RateDependence symonds{RateLaw::CowperSymonds, 40.0, 5.0, {}, {}};
  const RateDependence cook{RateLaw::JohnsonCook, 1.0, {}, 0.02, {}};
  RateDependence given = symonds;
  given.strain_rate = 1.0;
  const auto moving = [&](const RateDependence& rate, YieldModel yields) {
    Scene scene = cantilever();
    scene.material.rate = rate;
    scene.yield_model = yields;
    if (yields != YieldModel::Fibre) scene.yield_cap = YieldCap::FullyPlastic;
    return scene_warnings(prepare(scene, {.analysis = Analysis::Dynamics, .duration = 0.01}));
  };
  EXPECT_TRUE(warns(moving(symonds, YieldModel::PerAxis), words));
  EXPECT_TRUE(warns(moving(symonds, YieldModel::PerAxis), "10 % too large in a rectangle"));
  EXPECT_TRUE(warns(moving(cook, YieldModel::PerAxis), "by 1 % of its value at the reference"));
  EXPECT_FALSE(warns(moving(symonds, YieldModel::Fibre), words));
  EXPECT_FALSE(warns(with(given, YieldModel::PerAxis), words)) << "all fibres have one rate";
}

}  // namespace
}  // namespace plastica
