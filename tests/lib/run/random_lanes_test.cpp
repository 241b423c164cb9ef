#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "plastica/run/batch.hpp"
#include "plastica/run/lane_program.hpp"
#include "tests/support/random_batch.hpp"
#include "tests/support/response_bits.hpp"
#include "tests/support/sanitized.hpp"

/// Lanes against lone beams, in scenes by chance, at rest and in motion.
namespace plastica {
namespace {

TEST(RandomLanes, HaveTheBitsOfLoneBeams) {
  const unsigned batches = testing::kSanitized ? 25 : 600;
  std::size_t rode = 0;
  std::size_t ended_early = 0;
  for (unsigned seed = 1; seed <= batches; ++seed) {
    const std::vector<BatchCase> cases = testing::RandomBatch(seed).make();
    const std::vector<BatchRow> rows = run_batch(cases, {.threads = 1});
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const BatchRow alone = run_case(cases[i]);
      const std::string where = "batch " + std::to_string(seed) + ", case " + cases[i].id;
      EXPECT_EQ(rows[i].reason, alone.reason) << where;
      EXPECT_TRUE(testing::bits_of(rows[i].response) == testing::bits_of(alone.response)) << where;
      if (alone.response.status == Status::Rejected) continue;
      if (has_lanes(*prepare(cases[i].scene, cases[i].options).chain)) ++rode;
      if (alone.response.status != Status::Completed) ++ended_early;
    }
  }
  EXPECT_GT(rode, std::size_t{2} * batches);
  EXPECT_GT(ended_early, batches / 10);
}

}  // namespace
}  // namespace plastica
