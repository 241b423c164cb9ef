#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plastica/theory/elastica.hpp"
#include "plastica/theory/polygon.hpp"
#include "tests/reference/reference_table.hpp"
#include "tests/support/chain_scene.hpp"
#include "tests/support/tolerance.hpp"

/// Planar chains at large rotations against the elastica and the regular polygon.
namespace plastica {
namespace {

using std::numbers::pi;
using testing::tolerance;

/// A cantilever under the tip force alpha E I/L^2 across it.
Scene loaded_tip(int segments, double alpha) {
  Scene scene = testing::cantilever_scene(segments);
  scene.loads.push_back({.force = {0.0, alpha * testing::bending_stiffness_of(scene), 0.0}});
  return scene;
}

/// Distance of the chain's tip from the elastica's, over the way that the tip went.
double tip_error(int segments, double alpha, const theory::ElasticaTip& exact) {
  const Response response = testing::completed(loaded_tip(segments, alpha));
  const auto tip = testing::last_position(response, static_cast<std::size_t>(segments));
  EXPECT_EQ(tip[0], 0.0);
  return std::hypot(tip[1] - exact.deflection, tip[2] - exact.position) /
         std::hypot(exact.deflection, 1.0 - exact.position);
}

TEST(ElasticaRun, ConvergesWithOrderTwoUnderAllLoadsOfTheTable) {
  const testing::ReferenceTable table("elastica-cantilever/tip_dead_load.csv");
  ASSERT_EQ(table.rows(), 22U);
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double alpha = table.at("alpha_PL2_over_EI", i);
    SCOPED_TRACE(alpha);
    const theory::ElasticaTip exact = theory::elastica_tip_force(alpha);
    double error[4];
    for (int k = 0; k < 4; ++k) error[k] = tip_error(16 << k, alpha, exact);
    EXPECT_GE(std::log2(error[2] / error[3]), 1.95);
    // The bend of large loads, of the length 1/sqrt(alpha), takes segments before the order shows.
    if (alpha <= 20.0) {
      EXPECT_GE(std::log2(error[0] / error[1]), 1.9);
      EXPECT_GE(std::log2(error[1] / error[2]), 1.95);
    }
    if (alpha == 2.0) {
      EXPECT_LE(error[1], tolerance(0.0005));
    }
    if (alpha == 10.0) {
      EXPECT_LE(error[1], tolerance(0.001));
    }
  }
}

TEST(ElasticaRun, IsTheSameInPlaneAndSpace) {
  const Scene scene = loaded_tip(32, 5.0);
  const Response planar = testing::completed(scene, {.level = Level::Planar});
  const Response spatial = testing::completed(scene, {.level = Level::Spatial});
  for (std::size_t node = 0; node <= 32; ++node) {
    const auto a = testing::last_position(planar, node);
    const auto b = testing::last_position(spatial, node);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance(1e-10)) << node;
  }
}

TEST(ElasticaRun, RollsUpToTheRegularPolygonUnderATipMoment) {
  constexpr int kSegments = 16;
  Scene scene = testing::cantilever_scene(kSegments);
  scene.loads.push_back({.moment = {-2.0 * pi * testing::bending_stiffness_of(scene), 0.0, 0.0}});
  const Response response = testing::completed(scene);
  for (int node = 0; node <= kSegments; ++node) {
    auto exact = theory::polygon_node(kSegments, 2.0 * pi, std::min(node, kSegments - 1));
    // The last segment has the end's half turn, too: it lies along the tangent of the end.
    if (node == kSegments) exact[0] += 1.0 / kSegments;
    const auto at = testing::last_position(response, static_cast<std::size_t>(node));
    EXPECT_NEAR(at[2], exact[0], tolerance(1e-10)) << node;
    EXPECT_NEAR(at[1], exact[1], tolerance(1e-10)) << node;
  }
}

}  // namespace
}  // namespace plastica
