#include "plastica/theory/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plastica/theory/elastica.hpp"

namespace plastica::theory {
namespace {

using std::numbers::pi;

TEST(Polygon, IsTheSumOfItsTurnedSegments) {
  constexpr int kSegments = 7;
  for (const double rotation : {-2.0, 0.0, 1e-9, 0.3, 5.0}) {
    const double beta = rotation / kSegments;
    double x = 0.0, y = 0.0;
    for (int i = 1; i <= kSegments; ++i) {
      x += std::cos((i - 0.5) * beta) / kSegments;
      y += std::sin((i - 0.5) * beta) / kSegments;
      const auto node = polygon_node(kSegments, rotation, i);
      EXPECT_NEAR(node[0], x, 1e-14) << rotation;
      EXPECT_NEAR(node[1], y, 1e-14) << rotation;
    }
  }
}

TEST(Polygon, ClosesAfterAFullTurn) {
  for (const int n : {2, 3, 16, 1000}) {
    const auto tip = polygon_node(n, 2.0 * pi, n);
    EXPECT_NEAR(tip[0], 0.0, 1e-15) << n;
    EXPECT_NEAR(tip[1], 0.0, 1e-15) << n;
  }
}

TEST(Polygon, OfFourSegmentsIsASquareOnItsCorner) {
  const auto opposite = polygon_node(4, 2.0 * pi, 2);
  EXPECT_NEAR(opposite[0], 0.0, 1e-15);
  EXPECT_NEAR(opposite[1], 0.25 * std::numbers::sqrt2, 1e-15);
}

TEST(Polygon, TendsToTheRolledUpBeamWithOrderTwo) {
  const ElasticaTip exact = elastica_tip_moment(1.0);
  const auto error = [&](int n) {
    const auto tip = polygon_node(n, 1.0, n);
    return std::hypot(tip[0] - exact.position, tip[1] - exact.deflection);
  };
  EXPECT_NEAR(std::log2(error(100) / error(200)), 2.0, 1e-3);
  EXPECT_NEAR(polygon_radius(100, 1.0), 1.0 + 1e-4 / 24.0, 1e-9);
}

}  // namespace
}  // namespace plastica::theory
