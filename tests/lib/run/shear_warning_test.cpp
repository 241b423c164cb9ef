#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "plastica/run/scene_warnings.hpp"
#include "plastica/run/simulate.hpp"
#include "tests/lib/model/chain_scenes.hpp"
#include "tests/support/chain_scene.hpp"

namespace plastica {
namespace {

using testing::cantilever;

std::vector<std::string> shear_warnings(const Scene& scene) {
  std::vector<std::string> found;
  const std::vector<std::string> all = scene_warnings(prepare(scene, {}));
  std::ranges::copy_if(all, std::back_inserter(found), [](const std::string& text) {
    return text.find("shear") != std::string::npos;
  });
  return found;
}

TEST(ShearWarning, SaysWhatAShortBeamLeavesOut) {
  Scene scene = cantilever();
  scene.section.height = 0.2;
  // phi = 3 (E/G) (h^2/12)/(kappa L^2) = 3 2.6 0.04/12/0.85 = 0.0306, with nu = 0.3 and Cowper's
  // kappa = 13/15.3.
  const auto warnings = scene_warnings(prepare(scene, {}));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0],
      "the beam is 5 times as long as deep: shear, which rigid joints leave out, is about 2.97 % "
      "of the deflection under a force at its tip (Timoshenko); solver.translation = "
      "\"elastic\" has it");
  SolverOptions sheared;
  sheared.translation = JointTranslation::Elastic;
  EXPECT_EQ(scene_warnings(prepare(scene, sheared)), std::vector<std::string>{});
}

/// What they say of the share is what joints that shear show.
TEST(ShearWarning, SaysWhatASpanLeavesOut) {
  const auto deflection = [](Scene scene, JointTranslation translation) {
    scene.yield_model = YieldModel::Elastic;
    scene.beam.segments = 64;
    scene.probes.clear();
    testing::add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
    return testing::completed(scene, {.translation = translation}).probes[0].back();
  };
  for (const auto& [start, end] : {std::pair{SupportKind::Clamp, SupportKind::Clamp},
                                   std::pair{SupportKind::Pin, SupportKind::Roller},
                                   std::pair{SupportKind::Clamp, SupportKind::Roller}}) {
    Scene scene = cantilever();
    scene.supports = {{.at = Place::start(), .kind = start}, {.at = Place::end(), .kind = end}};
    if (end == SupportKind::Clamp) {
      scene.supports[1].hold = HeldFreedoms{true, true, false, true, true, true};
    }
    scene.loads = {{.at = {0.5, {}}, .force = {0.0, 1.0, 0.0}}};
    scene.section.height = 0.03;
    EXPECT_TRUE(shear_warnings(scene).empty());
    scene.section.height = 1.0 / 12.0;
    scene.material.shear_modulus = scene.material.youngs_modulus / 16.0;  // as of timber
    const double rigid = deflection(scene, JointTranslation::Rigid);
    const double sheared = deflection(scene, JointTranslation::Elastic);
    const std::vector<std::string> said = shear_warnings(scene);
    ASSERT_EQ(said.size(), 1U);
    const std::string before = "is about ";
    const double percent = std::stod(said[0].substr(said[0].find(before) + before.size()));
    EXPECT_NEAR(0.01 * percent, 1.0 - rigid / sheared, 0.004) << said[0];  // of 64 segments
  }
}

TEST(ShearWarning, SaysThatThickWallsAreTakenForThin) {
  Scene scene = cantilever();
  scene.section = {.shape = SectionShape::RectangularTube,
                   .width = 0.03,
                   .height = 0.045,
                   .inner_width = 0.015,
                   .inner_height = 0.03};
  const auto warnings = [&](JointTranslation translation) {
    SolverOptions options;
    options.translation = translation;
    std::vector<std::string> all = scene_warnings(prepare(scene, options));
    std::erase_if(all, [](const std::string& text) {
      return text.find("Cowper's of thin walls") == std::string::npos;
    });
    return all.size();
  };
  EXPECT_EQ(warnings(JointTranslation::Elastic), 1U);
  EXPECT_EQ(warnings(JointTranslation::Rigid), 0U);
  scene.section.shear_coefficient = 0.8;
  EXPECT_EQ(warnings(JointTranslation::Elastic), 0U);
  scene.section.shear_coefficient.reset();
  scene.section.inner_width = 0.025;
  scene.section.inner_height = 0.04;
  EXPECT_EQ(warnings(JointTranslation::Elastic), 0U);
}

}  // namespace
}  // namespace plastica
