#include "plastica/law/active_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "plastica/base/dual.hpp"
#include "plastica/base/pack.hpp"
#include "plastica/law/interior_point.hpp"
#include "plastica/law/project.hpp"
#include "tests/lib/law/gauge_of.hpp"

namespace plastica::law {
namespace {

using testing::Shaker;

template <class S>
using Rectangle = FirstYieldGauge<S, kPerimeterPoints, false>;
template <class S>
using Pieces = detail::ActivePieces<S, kPerimeterPoints>;

template <class S>
Rectangle<S> rectangle(double width, double height) {
  const GaugeForm form = gauge_form({.width = width, .height = height}, YieldModel::Interaction,
                                    YieldCap::FirstYield, Formulas::Mechanics);
  Rectangle<S> gauge;
  with_gauge<S>(form, [&](const auto& found) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(found)>, Rectangle<S>>) gauge = found;
  });
  return gauge;
}

const std::array<std::array<double, 2>, 3> kSides{{{0.05, 0.1}, {0.1, 0.1}, {0.1, 0.04}}};

/// A target in the orthant, beyond the surface.
struct Trial {
  SectionForce<double> compliance, target;
  double overshoot;
};

/// @param components  bits of the components that there are
/// @param most        largest overshoot
Trial random_trial(Shaker& shake, const Rectangle<double>& gauge, unsigned components,
                   double most) {
  Trial trial;
  for (std::size_t i = 0; i < kSectionAxes; ++i) {
    trial.compliance[i] = 0.8 + 0.5 * shake();
    // Some nearly absent.
    const double part = shake() > 0.9 ? 1e-6 : 1.0;
    trial.target[i] = (components >> i & 1U) != 0 ? part * (0.5 + 0.499 * shake()) : 0.0;
  }
  const double size = 1.0 + 1e-6 + most * (0.5 + 0.5 * shake());
  trial.target = (size / orthant_gauge(gauge, trial.target)) * trial.target;
  trial.overshoot = orthant_gauge(gauge, trial.target) - 1.0;
  return trial;
}

Pieces<double> project(const Rectangle<double>& gauge, const Trial& trial) {
  return {gauge, trial.compliance, trial.target, trial.overshoot, true};
}

/// Calls `use(gauge, trial)` for many trials: each section, each two or more components that there
/// can be.
template <class Use>
void for_each_trial(int count, double most, const Use& use) {
  Shaker shake(21);
  for (const auto& [width, height] : kSides) {
    const Rectangle<double> gauge = rectangle<double>(width, height);
    for (unsigned components = 3; components < 16; ++components) {
      if ((components & (components - 1)) == 0) continue;  // one alone returns along its axis
      for (int i = 0; i < count; ++i) use(gauge, random_trial(shake, gauge, components, most));
    }
  }
}

/// 10 000 trials, half of them far beyond the surface.
TEST(ActivePieces, FindTheClosestPointAsInteriorPointsDo) {
  for (const double most : {0.05, 3.0}) {
    for_each_trial(150, most, [&](const auto& gauge, const Trial& trial) {
      const Pieces<double> pieces = project(gauge, trial);
      if (!pieces.holds()) return;
      const SectionForce<double> point = pieces.result().point;
      EXPECT_LE(orthant_gauge(gauge, point), 1.0 + 1e-12);
      const SectionForce<double> other =
          detail::InteriorPoint<Rectangle<double>>(gauge, trial.compliance, trial.target,
                                                   trial.overshoot, true)
              .result()
              .point;
      // Interior points are off by up to the root of their gap where a bound only just holds. The
      // closest point is the one from which no other is nearer to the target's side.
      double gain = 0.0;
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        EXPECT_GE(point[i], 0.0);
        EXPECT_NEAR(point[i], other[i], 2e-5);
        gain += (trial.target[i] - point[i]) * (other[i] - point[i]) / trial.compliance[i];
      }
      EXPECT_LE(gain, 1e-12);
    });
  }
}

TEST(ActivePieces, LeaveFewTargetsToOtherWays) {
  for (const double most : {0.05, 3.0}) {
    int trials = 0;
    int left = 0;
    for_each_trial(150, most, [&](const auto& gauge, const Trial& trial) {
      ++trials;
      left += project(gauge, trial).holds() ? 0 : 1;
    });
    EXPECT_EQ(trials, 3 * 11 * 150);
    EXPECT_LE(left, (most < 1.0 ? 0.015 : 0.025) * trials);
    EXPECT_GT(left, 0) << "then nothing shows what becomes of those that are left";
  }
}

/// The return goes on where active pieces give up: one that they leave is on the surface, too.
TEST(ActivePieces, LeaveTargetsThatTheReturnStillFinds) {
  int left = 0;
  for_each_trial(150, 3.0, [&](const auto& gauge, const Trial& trial) {
    if (project(gauge, trial).holds()) return;
    ++left;
    const auto found =
        law::project(gauge, trial.compliance, trial.target, trial.overshoot, true).point;
    EXPECT_NEAR(orthant_gauge(gauge, found), 1.0, 1e-12);
  });
  EXPECT_GT(left, 0);
}

/// Differences cross an edge of the surface now and then.
TEST(ActivePieces, HaveTheSlopeOfTheirPoint) {
  int trials = 0;
  int wrong = 0;
  for_each_trial(8, 0.5, [&](const auto& gauge, const Trial& trial) {
    const Pieces<double> pieces = project(gauge, trial);
    if (!pieces.holds()) return;
    const auto slope = pieces.result().slope;
    double error = 0.0;
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      if (!(trial.target[j] > 1e-4)) continue;
      const auto at = [&](double step) {
        Trial moved = trial;
        moved.target[j] += step;
        moved.overshoot = orthant_gauge(gauge, moved.target) - 1.0;
        return project(gauge, moved).result().point;
      };
      const auto difference = (1.0 / 2e-6) * (at(1e-6) - at(-1e-6));
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        error = std::max(error, std::fabs(difference[i] - slope(i, j)));
      }
    }
    ++trials;
    wrong += error > 1e-4 ? 1 : 0;
  });
  EXPECT_GT(trials, 200);
  EXPECT_LE(wrong, trials / 50);
}

TEST(ActivePieces, GiveDualNumbersTheirSlope) {
  using D = Dual<double, 1>;
  const Rectangle<D> lifted = rectangle<D>(0.05, 0.1);
  const Rectangle<double> gauge = rectangle<double>(0.05, 0.1);
  Shaker shake(22);
  for (int trials = 0; trials < 200; ++trials) {
    const Trial trial = random_trial(shake, gauge, 15, 0.5);
    const Pieces<double> plain = project(gauge, trial);
    if (!plain.holds()) continue;
    for (std::size_t j = 0; j < kSectionAxes; ++j) {
      SectionForce<D> compliance, target;
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        compliance[i] = D(trial.compliance[i]);
        target[i] = i == j ? D::parameter(trial.target[i], 0) : D(trial.target[i]);
      }
      const D overshoot(trial.overshoot);
      const Pieces<D> pieces(lifted, compliance, target, overshoot, overshoot > D(0.0));
      ASSERT_TRUE(any(pieces.holds()));
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        EXPECT_NEAR(pieces.result().point[i].derivative(0), plain.result().slope(i, j), 1e-9);
      }
    }
  }
}

TEST(ActivePieces, GiveALaneTheBitsOfALoneDouble) {
  using Lanes = Pack<double, 8>;
  const Rectangle<Lanes> lanes = rectangle<Lanes>(0.05, 0.1);
  const Rectangle<double> gauge = rectangle<double>(0.05, 0.1);
  Shaker shake(23);
  for (int group = 0; group < 50; ++group) {
    std::array<Trial, 8> trials;
    SectionForce<Lanes> compliance, target;
    Lanes overshoot;
    for (int lane = 0; lane < 8; ++lane) {
      const unsigned components = lane < 6 ? 15U : static_cast<unsigned>(lane) - 1U;
      Trial& trial = trials[static_cast<std::size_t>(lane)];
      trial = random_trial(shake, gauge, components, lane % 2 == 0 ? 0.05 : 3.0);
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        compliance[i].set(lane, trial.compliance[i]);
        target[i].set(lane, trial.target[i]);
      }
      overshoot.set(lane, trial.overshoot);
    }
    const mask_t<Lanes> all = overshoot > constant<Lanes>(0);
    const Pieces<Lanes> pieces(lanes, compliance, target, overshoot, all);
    const Projection<Lanes> found = pieces.result();
    for (int lane = 0; lane < 8; ++lane) {
      const Pieces<double> alone = project(gauge, trials[static_cast<std::size_t>(lane)]);
      ASSERT_EQ(alone.holds(), pieces.holds()[lane]);
      if (!alone.holds()) continue;
      const Projection<double> expected = alone.result();
      for (std::size_t i = 0; i < kSectionAxes; ++i) {
        EXPECT_EQ(found.point[i][lane], expected.point[i]);
        for (std::size_t j = 0; j < kSectionAxes; ++j) {
          EXPECT_EQ(found.slope(i, j)[lane], expected.slope(i, j));
        }
      }
    }
  }
}

}  // namespace
}  // namespace plastica::law
