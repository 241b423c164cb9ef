#include "plastica/base/fused.hpp"

#include <gtest/gtest.h>

#include "plastica/chain/level.hpp"

namespace plastica {
namespace {

using FusedNumber = Fused<double>;
using FusedLanes = Fused<Pack<double, 8>>;

/// Numbers whose products are not exact.
constexpr double kA = 1.0 / 3.0, kB = 1.0 / 7.0, kC = -1.0 / 21.0, kD = 1.0 / 11.0;

TEST(Fused, RoundsAProductWithTheSumThatItGoesInto) {
  const FusedNumber a(kA), b(kB), c(kC), d(kD);
  EXPECT_EQ((a * b + c).value, multiply_add(kA, kB, kC));
  EXPECT_EQ((c + a * b).value, multiply_add(kA, kB, kC));
  EXPECT_EQ((a * b - c).value, multiply_add(kA, kB, -kC));
  EXPECT_EQ((c - a * b).value, multiply_add(-kA, kB, kC));
  EXPECT_EQ((a * b + c * d).value, multiply_add(kA, kB, kC * kD));
  EXPECT_EQ((a * b - c * d).value, multiply_add(kA, kB, -(kC * kD)));
  EXPECT_EQ((a * b * c + d).value, multiply_add(kA * kB, kC, kD));
  EXPECT_EQ(FusedNumber(-(a * b)).value, -(kA * kB));
  FusedNumber sum = c;
  sum += a * b;
  sum -= c * d;
  EXPECT_EQ(sum.value, multiply_add(-kC, kD, multiply_add(kA, kB, kC)));
}

TEST(Fused, ChoosesAmongProductsAsAmongNumbers) {
  const FusedNumber a(kA), b(kB), c(kC);
  EXPECT_EQ(max(a * b, c).value, kA * kB);
  EXPECT_EQ(min(c, a * b).value, kC);
  EXPECT_EQ(select(a < b, c, a * b).value, kA * kB);
}

TEST(Fused, GivesALaneTheBitsOfALoneNumber) {
  const auto rotated = [](const auto& scale) {
    using S = std::remove_cvref_t<decltype(scale)>;
    using L = chain::Spatial<S>;
    const Vec<S, 3> theta{{S(scale * constant<S>(kA)), S(-(scale * constant<S>(kB))), scale}};
    return L::compose(L::rotation(theta), L::rotation(L::add_rotation(theta, theta)));
  };
  Pack<double, 8> scales;
  for (int lane = 0; lane < 8; ++lane) scales.set(lane, 0.3 * lane);  // on both sides of 1 rad
  const auto all = rotated(FusedLanes(scales));
  for (int lane = 0; lane < 8; ++lane) {
    const auto alone = rotated(FusedNumber(0.3 * lane));
    for (std::size_t i = 0; i < 9; ++i) {
      EXPECT_EQ(all.axes.at[i].value[lane], alone.axes.at[i].value) << lane;
    }
  }
}

}  // namespace
}  // namespace plastica
