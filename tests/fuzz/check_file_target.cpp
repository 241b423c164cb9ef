#include <string>

#include "sweeps/check/claim.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {
namespace {

/// A check file, and the scenes, sweeps and fits that it names.
void read_check(Bytes bytes) {
  const std::string path = scratch_file("fuzzed.toml", text_of(bytes));
  const auto file = result_or_refused([&] { return sweeps::read_check_file(path); });
  if (!file) return;
  for (const std::string& note : file->notes) check_refusal(note);
}

const Registered kCheckFile{"check_file", read_check};

}  // namespace
}  // namespace plastica::fuzz
