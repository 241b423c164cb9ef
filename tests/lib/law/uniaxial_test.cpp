#include "plastica/law/uniaxial.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"

namespace plastica::law {
namespace {

using Lanes = Pack<double, 8>;
using FloatLanes = Pack<float, 16>;
using D = Dual<double, 3>;

constexpr double kE = 200e9;
constexpr double kY = 300e6;

/// A law of steel size for any scalar.
template <class S>
IdealPlastic<S> ideal() {
  return {constant<S>(kE), constant<S>(1.0) / constant<S>(kE), constant<S>(kY)};
}
template <class S>
LinearHardening<S> linear() {
  return {constant<S>(kE), constant<S>(kY), constant<S>(2e9), constant<S>(3e9)};
}
template <class S>
VoceChaboche<S> voce() {
  return {constant<S>(kE),
          constant<S>(kY),
          constant<S>(80e6),
          constant<S>(12.0),
          {constant<S>(20e9), constant<S>(4e9), constant<S>(0.5e9)},
          {constant<S>(300.0), constant<S>(40.0), constant<S>(0.0)}};
}

/// Stress at the end of a path, sample by sample.
template <class S, class Law>
S stress_after(const Law& law, const std::vector<double>& path) {
  typename Law::State state;
  S stress{};
  for (const double strain : path) {
    const auto now = respond(law, state, constant<S>(strain));
    state = now.state;
    stress = now.stress;
  }
  return stress;
}

const std::vector<double> kCycle{0.001, 0.004, 0.01, 0.008, 0.0, -0.01, -0.012, 0.003, 0.02};

TEST(IdealPlastic, FollowsTheClosedFormThroughLoadingAndUnloading) {
  const auto law = ideal<double>();
  EXPECT_DOUBLE_EQ(stress_after<double>(law, {0.001}), 200e6);
  EXPECT_DOUBLE_EQ(stress_after<double>(law, {0.01}), kY);
  // Back by twice the elastic range: the other side of the range.
  EXPECT_NEAR(stress_after<double>(law, {0.01, 0.01 - 0.002}), kY - 400e6, 1e-4);
  EXPECT_DOUBLE_EQ(stress_after<double>(law, {0.01, 0.0}), -kY);
}

TEST(IdealPlastic, SplitsTheStrainAndNeverLeavesTheYieldStress) {
  const auto law = ideal<double>();
  IdealPlastic<double>::State state;
  double path = 0.0;
  double before = 0.0;
  for (const double strain : kCycle) {
    const auto now = respond(law, state, strain);
    EXPECT_LE(std::fabs(now.stress), kY);
    EXPECT_NEAR(now.stress, kE * (strain - now.state.plastic), 1e-4);
    path += std::fabs(now.state.plastic - before);
    before = now.state.plastic;
    state = now.state;
  }
  EXPECT_NEAR(state.accumulated, path, 1e-15);
}

TEST(LinearHardening, FollowsTheClosedFormOfBothKinds) {
  const auto law = linear<double>();
  const double h = 5e9;
  const double tangent = kE * h / (kE + h);
  const double yield_strain = kY / kE;
  const double stress = kY + tangent * (0.01 - yield_strain);
  EXPECT_NEAR(stress_after<double>(law, {0.01}), stress, 1.0);
  // Reversed yield: the elastic range is 2 (Y + H_iso p), centred at the back stress.
  const double p = (stress - kY) / h;
  const double reversed = 3e9 * p - (kY + 2e9 * p);
  const double range = (stress - reversed) / kE;
  EXPECT_NEAR(stress_after<double>(law, {0.01, 0.01 - range}), reversed, 1.0);
  EXPECT_NEAR(stress_after<double>(law, {0.01, 0.01 - range - 0.001}), reversed - tangent * 0.001,
              1.0);
}

TEST(LinearHardening, WithoutModuliIsIdealPlasticity) {
  auto law = linear<double>();
  law.isotropic = law.kinematic = 0.0;
  EXPECT_NEAR(stress_after<double>(law, kCycle), stress_after<double>(ideal<double>(), kCycle),
              1e-4);
}

TEST(VoceChaboche, FollowsTheMonotonicClosedForm) {
  const auto law = voce<double>();
  VoceChaboche<double>::State state;
  const auto now = respond(law, state, 0.03);
  const double p = now.state.accumulated;
  const double expected = kY + 80e6 * (1.0 - std::exp(-12.0 * p)) +
                          20e9 / 300.0 * (1.0 - std::exp(-300.0 * p)) +
                          4e9 / 40.0 * (1.0 - std::exp(-40.0 * p)) + 0.5e9 * p;
  EXPECT_NEAR(now.stress, expected, 1e-6 * expected);
  EXPECT_NEAR(now.stress, kE * (0.03 - now.state.plastic), 1e-3);
}

TEST(VoceChaboche, WithoutBackStressesAndSaturationIsIdealPlasticity) {
  auto law = voce<double>();
  law.saturation = 0.0;
  law.back_modulus = {0.0, 0.0, 0.0};
  EXPECT_NEAR(stress_after<double>(law, kCycle), stress_after<double>(ideal<double>(), kCycle),
              1e-3);
}

TEST(VoceChaboche, WithOneLinearBackStressIsLinearKinematicHardening) {
  auto law = voce<double>();
  law.saturation = 0.0;
  law.back_modulus = {3e9, 0.0, 0.0};
  law.back_rate = {0.0, 0.0, 0.0};
  auto prager = linear<double>();
  prager.isotropic = 0.0;
  EXPECT_NEAR(stress_after<double>(law, kCycle), stress_after<double>(prager, kCycle), 1e-3);
}

TEST(VoceChaboche, DoesNotDependOnHowAPlasticPathIsSampled) {
  const auto law = voce<double>();
  std::vector<double> fine;
  double previous = 0.0;
  for (const double target : kCycle) {
    for (int i = 1; i <= 100; ++i) fine.push_back(previous + (target - previous) * i / 100.0);
    previous = target;
  }
  const double coarse = stress_after<double>(law, kCycle);
  EXPECT_NEAR(stress_after<double>(law, fine), coarse, 1e-9 * std::fabs(coarse));
}

TEST(VoceChaboche, TakesCyclicSofteningAndHugeIncrements) {
  auto law = voce<double>();
  law.saturation = -150e6;
  VoceChaboche<double>::State state;
  for (const double strain : {0.05, -0.05, 3.0, -3.0}) {
    const auto now = respond(law, state, strain);
    double back = 0.0;
    for (const double x : now.state.back_stress) back += x;
    const double yield = kY - 150e6 * (1.0 - std::exp(-12.0 * now.state.accumulated));
    EXPECT_NEAR(std::fabs(now.stress - back), yield, 1e-6 * kY) << strain;
    state = now.state;
  }
}

template <class Law>
void expect_tangent_matches_differences(const Law& law, double start, double strain) {
  typename Law::State state = respond(law, typename Law::State{}, start).state;
  const auto now = respond(law, state, strain);
  for (const double h : {1e-6, 1e-7}) {
    const double difference =
        (respond(law, state, strain + h).stress - respond(law, state, strain - h).stress) /
        (2.0 * h);
    EXPECT_NEAR(now.tangent, difference, 1e-4 * kE * h / 1e-6 + 1e-7 * kE) << strain;
  }
}

TEST(UniaxialLaws, ReturnTheTangentOfTheStress) {
  for (const double strain : {0.0005, 0.004, 0.02, -0.01}) {
    expect_tangent_matches_differences(ideal<double>(), 0.003, strain);
    expect_tangent_matches_differences(linear<double>(), 0.003, strain);
    expect_tangent_matches_differences(voce<double>(), 0.003, strain);
  }
}

/// Every lane of a pack, and the value of a dual, must have the bits of the lone double.
template <template <class> class Law, class Make>
void expect_same_for_all_scalars(const Make& make) {
  const Law<double> law = make.template operator()<double>();
  const double expected = stress_after<double>(law, kCycle);
  const auto lanes = stress_after<Lanes>(make.template operator()<Lanes>(), kCycle);
  for (int lane = 0; lane < 8; ++lane) EXPECT_EQ(lanes[lane], expected);
  EXPECT_EQ(stress_after<D>(make.template operator()<D>(), kCycle).value(), expected);
  const float single = stress_after<float>(make.template operator()<float>(), kCycle);
  EXPECT_NEAR(static_cast<double>(single), expected, 2e-4 * kY);
  const auto floats = stress_after<FloatLanes>(make.template operator()<FloatLanes>(), kCycle);
  for (int lane = 0; lane < 16; ++lane) EXPECT_EQ(floats[lane], single);
}

TEST(UniaxialLaws, GiveTheSameForEveryScalar) {
  expect_same_for_all_scalars<IdealPlastic>([]<class S>() { return ideal<S>(); });
  expect_same_for_all_scalars<LinearHardening>([]<class S>() { return linear<S>(); });
  expect_same_for_all_scalars<VoceChaboche>([]<class S>() { return voce<S>(); });
}

TEST(UniaxialLaws, GiveALaneTheSameBitsWhateverItsNeighboursDo) {
  const auto lone_law = voce<double>();
  const auto law = voce<Lanes>();
  VoceChaboche<Lanes>::State state;
  VoceChaboche<double>::State lone[8];
  for (const double strain : kCycle) {
    Lanes strains;
    for (int lane = 0; lane < 8; ++lane) strains.set(lane, strain * (0.1 + 0.7 * lane));
    const auto now = respond(law, state, strains);
    state = now.state;
    for (int lane = 0; lane < 8; ++lane) {
      const auto expected = respond(lone_law, lone[lane], strain * (0.1 + 0.7 * lane));
      lone[lane] = expected.state;
      EXPECT_EQ(now.stress[lane], expected.stress) << strain << " in lane " << lane;
      EXPECT_EQ(now.tangent[lane], expected.tangent);
      EXPECT_EQ(state.accumulated[lane], expected.state.accumulated);
    }
  }
}

TEST(VoceChaboche, IsSmoothDownToABackRateOfZero) {
  const auto with = [](double back_rate) {
    auto law = voce<double>();
    law.back_rate[0] = back_rate;
    return stress_after<double>(law, kCycle);
  };
  for (const double rate : {1e-12, 1e-9, 1e-6}) EXPECT_NEAR(with(rate), with(0.0), 10.0) << rate;
  auto law = voce<D>();
  law.back_rate[0] = D::parameter(0.0, 0);
  const double difference = (with(2e-3) - with(0.0)) / 2e-3;
  EXPECT_NEAR(stress_after<D>(law, kCycle).derivative(0), difference, 1e-3 * std::fabs(difference));
}

TEST(UniaxialLaws, LetDerivativesThroughPlasticCycles) {
  const auto with = [](double saturation, double rate, double modulus) {
    auto law = voce<double>();
    law.saturation = saturation;
    law.rate = rate;
    law.back_modulus[0] = modulus;
    return stress_after<double>(law, kCycle);
  };
  auto law = voce<D>();
  law.saturation = D::parameter(80e6, 0);
  law.rate = D::parameter(12.0, 1);
  law.back_modulus[0] = D::parameter(20e9, 2);
  const D stress = stress_after<D>(law, kCycle);
  const double dq = (with(80e6 + 1e3, 12, 20e9) - with(80e6 - 1e3, 12, 20e9)) / 2e3;
  const double db = (with(80e6, 12 + 1e-4, 20e9) - with(80e6, 12 - 1e-4, 20e9)) / 2e-4;
  const double dc = (with(80e6, 12, 20e9 + 1e5) - with(80e6, 12, 20e9 - 1e5)) / 2e5;
  EXPECT_NEAR(stress.derivative(0), dq, 1e-6 * std::fabs(dq) + 1e-9);
  EXPECT_NEAR(stress.derivative(1), db, 1e-6 * std::fabs(db));
  EXPECT_NEAR(stress.derivative(2), dc, 1e-5 * std::fabs(dc));
}

}  // namespace
}  // namespace plastica::law
