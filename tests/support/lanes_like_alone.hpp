#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "plastica/run/batch.hpp"
#include "tests/support/response_bits.hpp"
#include "tests/support/sanitized.hpp"

namespace plastica::testing {

/// Those that this processor has; under sanitizers, which see the same code in each, the first
/// alone.
inline std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> sets{InstructionSet::Baseline};
  for (const InstructionSet isa : {InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (!kSanitized && has_instruction_set(isa)) sets.push_back(isa);
  }
  return sets;
}

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
