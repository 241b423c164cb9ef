#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/flexible_cantilever.hpp"

/// Beams that turn by a quarter of a circle within a small part of their load find the equilibrium
/// that the load leads to, and no other one.
namespace plastica {
namespace {

using testing::FlexibleLoad;

TEST(FlexibleBeams, ShootingGivesTheDeflectionOfASmallWeight) {
  // q L^4/(8 E I), the next term being of the third order.
  EXPECT_NEAR(testing::elastica_weight(1e-3).deflection / (1e-3 / 8.0), 1.0, 1e-6);
}

TEST(FlexibleBeams, HangFromTheClampHoweverFewTheSteps) {
  for (const FlexibleLoad kind : {FlexibleLoad::TipForce, FlexibleLoad::Weight}) {
    for (const double load : {20.0, 500.0, 1e4}) {
      const theory::ElasticaTip exact = testing::flexible_tip(kind, load);
      for (const int segments : {8, 64}) {
        for (const int steps : {1, 5, 20}) {
          SCOPED_TRACE(::testing::Message() << load << ' ' << segments << ' ' << steps);
          const auto n = static_cast<std::size_t>(segments);
          const Response response = testing::completed(
              testing::flexible_cantilever(kind, load, segments), {.steps = steps});
          EXPECT_LE(testing::flexible_error(response, n, exact),
                    testing::flexible_tolerance(load, n));
          EXPECT_NEAR(testing::rotated_in_all(response, n), exact.slope, 0.05);
        }
      }
    }
  }
}

TEST(FlexibleBeams, HangAlikeUnderALoadThatIsThereFromTheBeginning) {
  for (const FlexibleLoad kind : {FlexibleLoad::TipForce, FlexibleLoad::Weight}) {
    const Response rising =
        testing::completed(testing::flexible_cantilever(kind, 1e3, 32), {.steps = 20});
    const Response at_once =
        testing::completed(testing::flexible_cantilever(kind, 1e3, 32, History::constant()),
                           {.duration = 1.0, .steps = 1});
    const auto a = testing::last_position(rising, 32);
    const auto b = testing::last_position(at_once, 32);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-8);
  }
}

TEST(FlexibleBeams, TurnAlikeInThePlaneAndInSpace) {
  const Scene scene = testing::flexible_cantilever(FlexibleLoad::TipForce, 2e3, 48);
  const Response plane = testing::completed(scene, {.level = Level::Planar, .steps = 3});
  const Response space = testing::completed(scene, {.level = Level::Spatial, .steps = 3});
  const auto a = testing::last_position(plane, 48);
  const auto b = testing::last_position(space, 48);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 1e-8);
}

}  // namespace
}  // namespace plastica
