// Flexible cantilevers under a tip force and under their weight, of load parameters 1 ... 10^4,
// with 8 ... 256 segments and 1 ... 100 steps: none lands on another equilibrium than the
// elastica's. PLASTICA_STUDY=full runs all, =sample those of a few steps.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/support/flexible_cantilever.hpp"

namespace plastica {
namespace {

using testing::FlexibleLoad;

TEST(FlexibleCantilevers, LandNowhereElse) {
  const char* study = std::getenv("PLASTICA_STUDY");
  const bool full = study != nullptr && std::string(study) == "full";
  const std::vector<int> steps = full ? std::vector{1, 2, 5, 10, 20, 50, 100} : std::vector{5, 20};
  int all = 0;
  int wrong = 0;
  for (const FlexibleLoad kind : {FlexibleLoad::TipForce, FlexibleLoad::Weight}) {
    for (const double load : {1.0, 5.0, 20.0, 100.0, 500.0, 1e3, 2e3, 5e3, 1e4}) {
      const theory::ElasticaTip exact = testing::flexible_tip(kind, load);
      for (const int segments : {8, 16, 32, 64, 128, 256}) {
        for (const int count : steps) {
          const auto n = static_cast<std::size_t>(segments);
          const Response response =
              simulate(testing::flexible_cantilever(kind, load, segments), {.steps = count});
          const bool right =
              response.status == Status::Completed &&
              testing::flexible_error(response, n, exact) <= testing::flexible_tolerance(load, n) &&
              std::fabs(testing::rotated_in_all(response, n) - exact.slope) <= 0.05;
          ++all;
          wrong += right ? 0 : 1;
          EXPECT_TRUE(right) << (kind == FlexibleLoad::Weight ? "weight " : "tip force ") << load
                             << ", " << segments << " segments, " << count << " steps";
        }
      }
    }
  }
  std::printf("%d of %d elsewhere\n", wrong, all);
}

}  // namespace
}  // namespace plastica
