#include <gtest/gtest.h>

#include "plastica/run/rounding_warning.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/sanitized.hpp"

// Springs so stiff, or loads so small, that the rounding of places makes forces above the
// tolerance of the equilibrium.

namespace plastica {
namespace {

using testing::add_probe;
using testing::chain_scene;
using testing::completed;
using testing::last_of;

/// A beam on a pin and a spring, loaded in its middle.
Scene propped(double stiffness, double force, YieldModel model) {
  Scene scene = chain_scene(20);
  scene.yield_model = model;
  scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
  scene.supports.push_back(
      {.at = Place::end(), .kind = SupportKind::Elastic, .stiffness = {stiffness, stiffness, 0.0}});
  scene.loads.push_back({.at = {0.5, {}}, .force = {0.0, force, 0.0}});
  add_probe(scene, ProbeQuantity::Displacement, {0.5, {}}, Component::Y);
  return scene;
}

// Scaled by the load, the displacement is that on a softer spring of a larger load: linear, and a
// spring that yields by less than 1e-8 of the beam's own displacement.
TEST(StiffSprings, HoldAtAnyLoad) {
  for (const auto level : {Level::Planar, Level::Spatial}) {
    for (const auto translation : {JointTranslation::Rigid, JointTranslation::Elastic}) {
      SolverOptions options{.level = level, .steps = 8};
      options.translation = translation;
      const double known =
          last_of(completed(propped(1e12, 1e-2, YieldModel::Elastic), options), 0) / 1e-2;
      for (const auto model : {YieldModel::Elastic, YieldModel::Interaction}) {
        for (const double stiffness : {1e13, 1e14, 1e15}) {
          if (testing::kSanitized && stiffness < 1e15) continue;
          for (const double force : {1e-6, 1e-4, 1e-2, 1.0}) {
            SCOPED_TRACE(::testing::Message() << stiffness << " N/m, " << force << " N");
            const Response response = completed(propped(stiffness, force, model), options);
            EXPECT_NEAR(last_of(response, 0) / force / known, 1.0, 2e-4);
          }
        }
      }
    }
  }
}

TEST(StiffSprings, AreNamedWhereRoundingIsSeen) {
  const SolverOptions options{.level = Level::Planar, .steps = 4};
  for (const bool seen : {false, true}) {
    const Scene scene = propped(seen ? 1e14 : 1e10, 100.0, YieldModel::Elastic);
    const auto said = rounding_warnings(scene, completed(scene, options));
    ASSERT_EQ(said.size(), seen ? 1U : 0U);
    if (seen) {
      EXPECT_EQ(said[0].find("support 2: its stiffness makes some 0.0222 N"), 0U) << said[0];
    }
  }
}

// A moment spring to the ground as stiff as can be is a clamp.
TEST(StiffSprings, OfRotationAreClamps) {
  for (const auto level : {Level::Planar, Level::Spatial}) {
    const auto tip_of = [&](double stiffness, double force) {
      Scene scene = chain_scene(16);
      scene.supports.push_back({.at = Place::start(), .kind = SupportKind::Pin});
      scene.supports.push_back({.at = Place::start(),
                                .kind = SupportKind::Elastic,
                                .rotational_stiffness = {stiffness, stiffness, 0.0}});
      scene.loads.push_back({.at = Place::end(), .force = {0.0, force, 0.0}});
      add_probe(scene, ProbeQuantity::Displacement, Place::end(), Component::Y);
      return last_of(completed(scene, {.level = level, .steps = 8}), 0) / force;
    };
    const double known = tip_of(1e11, 1e-2);
    for (const double stiffness : {1e13, 1e15}) {
      for (const double force : {1e-6, 1e-3}) {
        SCOPED_TRACE(::testing::Message() << stiffness << " N m/rad, " << force << " N");
        EXPECT_NEAR(tip_of(stiffness, force) / known, 1.0, 2e-4);
      }
    }
  }
}

}  // namespace
}  // namespace plastica
