#include "plastica/base/sine_cosine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plastica {
namespace {

TEST(SineCosine, AgreesWithTheCLibraryInEveryQuadrant) {
  for (double x = -20.0; x <= 20.0; x += 0.00917) {
    const SineCosine<double> at(x);
    EXPECT_NEAR(at.sine, std::sin(x), 3e-16) << x;
    EXPECT_NEAR(at.cosine, std::cos(x), 3e-16) << x;
    const auto f = static_cast<float>(x);
    const SineCosine<float> coarse(f);
    EXPECT_NEAR(coarse.sine, std::sin(static_cast<double>(f)), 2e-7) << x;
    EXPECT_NEAR(coarse.cosine, std::cos(static_cast<double>(f)), 2e-7) << x;
  }
}

TEST(SineCosine, IsExactAtZeroAndStaysAccurateForLargeAngles) {
  EXPECT_EQ(SineCosine<double>(0.0).sine, 0.0);
  EXPECT_EQ(SineCosine<double>(0.0).cosine, 1.0);
  for (const double x : {1e3, 12345.678, -54321.0, 99999.0}) {
    EXPECT_NEAR(SineCosine<double>(x).sine, std::sin(x), 1e-14) << x;
    EXPECT_NEAR(SineCosine<double>(x).cosine, std::cos(x), 1e-14) << x;
  }
}

template <class Lanes, class Real>
void expect_lanes_as_alone(int lanes) {
  Lanes x = constant<Lanes>(0);
  for (int lane = 0; lane < lanes; ++lane) x.set(lane, Real(1.37) * static_cast<Real>(lane) - 5);
  const SineCosine<Lanes> all(x);
  for (int lane = 0; lane < lanes; ++lane) {
    const SineCosine<Real> alone(x[lane]);
    EXPECT_EQ(all.sine[lane], alone.sine) << lane;
    EXPECT_EQ(all.cosine[lane], alone.cosine) << lane;
  }
}

TEST(SineCosine, GivesEachLaneTheBitsOfALoneNumber) {
  expect_lanes_as_alone<Pack<double, 8>, double>(8);
  expect_lanes_as_alone<Pack<float, 16>, float>(16);
}

}  // namespace
}  // namespace plastica
