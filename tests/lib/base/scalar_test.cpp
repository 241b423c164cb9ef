#include "plastica/base/scalar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"

namespace plastica {
namespace {

/// Distance in units in the last place of the expected value.
template <class T>
double ulps(T computed, double expected) {
  const T rounded = static_cast<T>(expected);
  const T next = std::nextafter(rounded, std::numeric_limits<T>::infinity());
  return std::fabs((static_cast<double>(computed) - expected) /
                   static_cast<double>(next - rounded));
}

TEST(Exp, IsWithinOneAndAHalfUnitsOfTheTrueValue) {
  double worst = 0.0;
  double worst_float = 0.0;
  for (int i = -7000; i <= 7000; ++i) {
    const double x = 0.1013 * i;
    if (x < -700.0 || x > 708.0) continue;
    worst = std::max(worst, ulps(exp(x), std::exp(x)));
    const auto f = static_cast<float>(x * 0.12);
    worst_float = std::max(worst_float, ulps(exp(f), std::exp(static_cast<double>(f))));
  }
  EXPECT_LT(worst, 1.5);
  EXPECT_LT(worst_float, 1.5);
}

TEST(Exp, EndsInZeroAndInfinity) {
  EXPECT_EQ(exp(-1000.0), 0.0);
  EXPECT_EQ(exp(1000.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(exp(0.0), 1.0);
  EXPECT_EQ(exp(-100.0F), 0.0F);
  EXPECT_TRUE(std::isnan(exp(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Log, IsWithinTwoUnitsOfTheTrueValue) {
  double worst = 0.0;
  for (int i = -3000; i <= 3000; ++i) {
    if (i == 0) continue;
    const double x = std::exp(0.2 * i);
    worst = std::max(worst, ulps(log(x), std::log(x)));
  }
  EXPECT_LT(worst, 2.0);
  EXPECT_EQ(log(1.0), 0.0);
}

TEST(Sine, AgreesWithTheTrueValueInEveryQuadrant) {
  for (int i = -4000; i <= 4000; ++i) {
    const double x = 0.0157 * i;
    EXPECT_NEAR(sin(x), std::sin(x), 3e-16) << x;
    EXPECT_NEAR(cos(x), std::cos(x), 3e-16) << x;
    const auto f = static_cast<float>(x);
    EXPECT_NEAR(sin(f), std::sin(static_cast<double>(f)), 2e-7) << x;
    EXPECT_NEAR(cos(f), std::cos(static_cast<double>(f)), 2e-7) << x;
  }
}

TEST(Sine, StaysAccurateForLargeAngles) {
  for (const double x : {1e3, 12345.678, -54321.0, 99999.0}) {
    EXPECT_NEAR(sin(x), std::sin(x), 1e-14) << x;
    EXPECT_NEAR(cos(x), std::cos(x), 1e-14) << x;
  }
}

using Lanes = Pack<double, 8>;
using FloatLanes = Pack<float, 16>;

TEST(Pack, GivesEachLaneTheBitsOfALoneDouble) {
  Lanes x;
  for (int lane = 0; lane < 8; ++lane) x.set(lane, 3.7 * lane - 11.3);
  const Lanes half = constant<Lanes>(0.5);
  const Lanes e = exp(x);
  const Lanes s = sin(x * half);
  const Lanes m = max(x, half) / (x * x + half);
  const Lanes a = abs(x);
  const Lanes r = sqrt(a);
  const Lanes g = sign(x);
  for (int lane = 0; lane < 8; ++lane) {
    const double v = 3.7 * lane - 11.3;
    EXPECT_EQ(e[lane], exp(v));
    EXPECT_EQ(s[lane], sin(v * 0.5));
    EXPECT_EQ(m[lane], max(v, 0.5) / (v * v + 0.5));
    EXPECT_EQ(a[lane], abs(v));
    EXPECT_EQ(r[lane], sqrt(abs(v)));
    EXPECT_EQ(g[lane], sign(v));
  }
}

TEST(Pack, WorksWithSixteenFloats) {
  FloatLanes x;
  for (int lane = 0; lane < 16; ++lane) x.set(lane, 0.5F * static_cast<float>(lane) - 4.0F);
  const FloatLanes e = exp(x);
  const FloatLanes a = abs(x);
  for (int lane = 0; lane < 16; ++lane) {
    const float v = 0.5F * static_cast<float>(lane) - 4.0F;
    EXPECT_EQ(e[lane], exp(v));
    EXPECT_EQ(a[lane], std::fabs(v));
  }
}

TEST(Pack, SelectsAndAsksByLane) {
  Lanes x;
  for (int lane = 0; lane < 8; ++lane) x.set(lane, lane);
  const auto mask = x > constant<Lanes>(4.0);
  EXPECT_TRUE(any(mask));
  EXPECT_FALSE(any(x > constant<Lanes>(7.0)));
  EXPECT_FALSE(any(mask & !mask));
  const Lanes chosen = select(mask, constant<Lanes>(1.0), constant<Lanes>(-1.0));
  EXPECT_EQ(chosen[4], -1.0);
  EXPECT_EQ(chosen[5], 1.0);
}

TEST(Pack, LoadsAndStoresInOrder) {
  const double from[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  double to[8] = {};
  Lanes::load(from).store(to);
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(to[lane], from[lane]);
}

/// f(x, y) of all operations, to differentiate.
template <class S>
S mixture(const S& x, const S& y) {
  return exp(x * y) + sin(x) / sqrt(y) - cos(y) * abs(x - y) + max(x, y) * min(x, y) - sign(x) * y;
}

TEST(Dual, AgreesWithFiniteDifferencesOverDecades) {
  using D = Dual<double, 2>;
  const double x = 0.7;
  const double y = 1.3;
  const D d = mixture(D::parameter(x, 0), D::parameter(y, 1));
  EXPECT_EQ(d.value(), mixture(x, y));
  for (const double h : {1e-3, 1e-4, 1e-5}) {
    const double dx = (mixture(x + h, y) - mixture(x - h, y)) / (2.0 * h);
    const double dy = (mixture(x, y + h) - mixture(x, y - h)) / (2.0 * h);
    EXPECT_NEAR(d.derivative(0), dx, 10.0 * h * h + 1e-10);
    EXPECT_NEAR(d.derivative(1), dy, 10.0 * h * h + 1e-10);
  }
}

TEST(Dual, HoldsAsManyDerivativesAsAreAskedFor) {
  const auto sum_of_squares = [](auto... x) { return ((x * x) + ...); };
  using D = Dual<double, 5>;
  const D sum = sum_of_squares(D::parameter(1.0, 0), D::parameter(2.0, 1), D::parameter(3.0, 2),
                               D::parameter(4.0, 3), D::parameter(5.0, 4));
  EXPECT_EQ(sum.value(), 55.0);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(sum.derivative(i), 2.0 * (1.0 + static_cast<double>(i))) << i;
  using F = Dual<float, 3>;
  EXPECT_EQ(sum_of_squares(F::parameter(2.0F, 2)).derivative(2), 4.0F);
  EXPECT_EQ(sum_of_squares(F::parameter(2.0F, 2)).derivative(1), 0.0F);
}

TEST(Dual, TakesTheSlopeOfItsSideAtAKink) {
  using D = Dual<double, 1>;
  const D slope = D::parameter(0.0, 0);
  EXPECT_EQ(abs(slope).derivative(0), 1.0);
  EXPECT_EQ(abs(D::parameter(-2.0, 0)).value(), 2.0);
  EXPECT_EQ(abs(D::parameter(-2.0, 0)).derivative(0), -1.0);
  EXPECT_EQ(max(slope, D(0.0)).derivative(0), 1.0);  // of equal ones the first
  EXPECT_EQ(max(D(0.0), slope).derivative(0), 0.0);
}

TEST(Dual, CarriesPacks) {
  using D = Dual<Lanes, 1>;
  Lanes x;
  for (int lane = 0; lane < 8; ++lane) x.set(lane, 0.3 * lane);
  const D e = exp(D::parameter(x, 0) * constant<D>(2.0));
  for (int lane = 0; lane < 8; ++lane) {
    EXPECT_EQ(e.value()[lane], exp(x[lane] * 2.0));
    EXPECT_EQ(e.derivative(0)[lane], 2.0 * exp(x[lane] * 2.0));
  }
}

}  // namespace
}  // namespace plastica
