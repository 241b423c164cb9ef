#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/command.hpp"

namespace plastica::testing {

/// Runs compare_results.py: bit by bit, all outside /meta.
/// @param options  such as {"--but", "/inputs"}
inline CommandResult compare_results(const Workplace& place, std::vector<std::string> options,
                                     const std::vector<std::string>& results) {
  options.insert(options.begin(),
                 {"-B", std::string(PLASTICA_SOURCE_DIR) + "/tests/cli/compare_results.py"});
  options.insert(options.end(), results.begin(), results.end());
  return place.run_program(PLASTICA_PYTHON, std::move(options));
}

inline void expect_same_bits(const Workplace& place, const std::vector<std::string>& results,
                             const std::vector<std::string>& options = {}) {
  const CommandResult compared = compare_results(place, options, results);
  EXPECT_EQ(compared.code, 0) << compared.out << compared.err;
}

}  // namespace plastica::testing
