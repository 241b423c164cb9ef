#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/response_bits.hpp"

namespace plastica::testing {

inline constexpr InstructionSet kInstructionSets[] = {InstructionSet::Baseline,
                                                      InstructionSet::Avx2, InstructionSet::Avx512};

/// A batch gives each case the bits that it has alone.
inline void expect_bits_of_alone(const std::vector<BatchCase>& cases, int threads = 1) {
  BatchOptions options;
  options.threads = threads;
  const std::vector<BatchRow> rows = run_batch(cases, options);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Response alone = simulate(cases[i].scene, cases[i].options);
    EXPECT_EQ(rows[i].reason, "");
    EXPECT_EQ(rows[i].response.status, alone.status) << cases[i].id;
    EXPECT_TRUE(bits_of(rows[i].response) == bits_of(alone))
        << cases[i].id << " of scheme " << static_cast<int>(cases[i].options.scheme);
  }
}

}  // namespace plastica::testing
