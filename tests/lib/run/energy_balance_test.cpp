#include <gtest/gtest.h>

#include <array>

#include "plastica/run/response.hpp"

namespace plastica {
namespace {

TEST(EnergyBalance, CountsWhatItCannotExplain) {
  const std::array samples{Energies{.kinetic = 2.0, .external = 2.0},
                           Energies{.kinetic = 1.0, .external = 1.1, .residual = -0.1}};
  EXPECT_DOUBLE_EQ(energy_balance_error(samples), 0.05);
}

TEST(EnergyBalance, CountsWhatASchemeMakesAndNotWhatItDissipates) {
  const std::array makes{Energies{.kinetic = 3.0, .numerical_dissipation = -1.0, .external = 2.0}};
  EXPECT_DOUBLE_EQ(energy_balance_error(makes), 1.0 / 3.0);
  const std::array takes{Energies{.kinetic = 1.0, .numerical_dissipation = 1.0, .external = 2.0}};
  EXPECT_DOUBLE_EQ(energy_balance_error(takes), 0.0);
}

TEST(EnergyBalance, IsRightWhereNothingMoves) {
  EXPECT_EQ(energy_balance_error(std::array<Energies, 2>{}), 0.0);
}

}  // namespace
}  // namespace plastica
