#include <gtest/gtest.h>

#include <cmath>

#include "tests/sweeps/advise/advised_scenes.hpp"
#include "tests/sweeps/sprung_beam.hpp"

namespace plastica::sweeps {
namespace {

TEST(AdviceOfUnlikeOrders, KeepsItsPromiseWhereTheyCancel) {
  // N and 2N segments agree to 0.2 % from 6 to 12, where both are 2 % off.
  const plastica::Setup setup = sprung_beam(8);
  const double exact = force_of_spring(setup);
  for (const double within : {0.03, 0.02, 0.015, 0.01, 0.005}) {
    const Advice advice = advise(setup, asked(within));
    ASSERT_EQ(advice.end, AdviceEnd::Found) << within;
    const double error = std::fabs(end_of(setup, advice) / exact - 1.0);
    EXPECT_LE(error, advice.promised) << within;
    EXPECT_LE(advice.promised, within);
  }
}

}  // namespace
}  // namespace plastica::sweeps
