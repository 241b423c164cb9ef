#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plastica::fuzz {

/// Result files of each kind, whole, as a run would write them: fits, fits through scenes, a motion
/// that breaks, a coupon, a cantilever, a sweep. They are made once, when they are first asked for:
/// as files they would be a megabyte of the tree.
const std::vector<std::string>& result_bases();

/// What the first byte of fuzzed bytes says: which file is changed, and whether what was read of it
/// is written again.
struct ResultChoice {
  const std::string& base;
  bool again;
};
ResultChoice result_choice(std::size_t byte);

/// Writes a file behind a digest that is its own. @return its path
std::string sealed_scratch_file(const std::string& content);

}  // namespace plastica::fuzz
