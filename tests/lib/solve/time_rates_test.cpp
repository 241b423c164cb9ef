#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/chain.hpp"

/// How a chain moves in a unit of time, from its tangent, against differences of its equilibria.
namespace plastica {
namespace {

/// Bent by a force in its middle, with an end that is moved and turned.
Scene turned_end(bool in_space) {
  Scene scene = testing::cantilever(8, {in_space ? 30.0 : 0.0, -100.0, 0.0});
  scene.yield_model = YieldModel::Elastic;
  scene.loads[0].at = {0.5, {}};
  Support end;
  end.at = Place::end();
  end.hold = HeldFreedoms{true, true, false, true, true, true};
  end.translation = {0.0, 0.05, 0.0};
  end.rotation = {0.7, in_space ? 0.2 : 0.0, in_space ? 0.9 : 0.0};
  scene.supports.push_back(end);
  return scene;
}

template <class L>
void expect_rates(bool in_space) {
  const Scene scene = turned_end(in_space);
  testing::SolvedChain<L, false, law::ElasticSection<double>> solved(
      scene, material_values(scene.material));
  const auto& chain = solved.build.chain;
  auto& w = solved.work;
  constexpr double kTime = 0.8;
  constexpr double kStep = 1e-4;
  std::vector<typename L::Spin> angles[3];
  for (const int side : {-1, 1, 0}) {
    solved.go_to(kTime + side * kStep, 8);
    angles[side + 1] = w.q.angle;
  }
  solve::detail::assemble(chain, *solved.joints, w);
  w.recursion.factor(chain, w.q, w.placement, w.stage, w.joints, w.outer_forces, w.transmitted);
  solve::PathCondition<L> unit_time;
  unit_time.active = true;
  unit_time.time_slope = 1.0;
  unit_time.value = -1.0;
  solve::detail::solve_imbalance(chain, unit_time, w);
  for (std::size_t k = 0; k < chain.constraints.size(); ++k) {
    solve::detail::solve_constraint(chain, k, w);
  }
  solve::detail::solve_time(chain, unit_time, w);
  solve::detail::join_columns(chain, unit_time, w);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    typename L::Spin spin;
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      spin[k] = w.columns.back().joint[i][k];
      for (std::size_t j = 0; j < chain.constraints.size(); ++j) {
        spin[k] += w.small.b(j) * w.columns[1 + j].joint[i][k];
      }
      spin[k] *= kStep;
    }
    const auto ahead = L::add_rotation(spin, angles[1][i]);
    const auto behind = L::add_rotation(-1.0 * spin, angles[1][i]);
    for (std::size_t k = 0; k < L::kRotations; ++k) {
      const double rate = (ahead[k] - behind[k]) / (2.0 * kStep);
      const double difference = (angles[2][i][k] - angles[0][i][k]) / (2.0 * kStep);
      EXPECT_NEAR(rate, difference, 1e-7) << i << ' ' << k;
    }
  }
}

TEST(TimeRates, OfAnEndThatTurnsAreThoseOfItsEquilibriaInThePlane) {
  expect_rates<chain::Planar<double>>(false);
}

TEST(TimeRates, OfAnEndThatTurnsAreThoseOfItsEquilibriaInSpace) {
  expect_rates<chain::Spatial<double>>(true);
}

}  // namespace
}  // namespace plastica
