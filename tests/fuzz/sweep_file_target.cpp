#include <string>

#include "sweeps/plan/sweep.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace plastica::fuzz {
namespace {

/// A sweep file, the scene that it names, and the first and last of its cases.
void read_sweep(Bytes bytes) {
  const auto sweep = result_or_refused([&] {
    return sweeps::parse_sweep(std::string(text_of(bytes)), scratch_path("fuzzed.toml"));
  });
  if (!sweep) return;
  for (const std::string& note : sweep->notes) check_refusal(note);
  read_or_refused([&] {
    const sweeps::CaseTable cases(*sweep);
    require(cases.size() <= sweeps::kMaxCases, "more cases than a sweep may have");
    if (cases.size() == 0) return;
    cases.id(0);
    cases.id(cases.size() - 1);
  });
}

const Registered kSweepFile{"sweep_file", read_sweep};

}  // namespace
}  // namespace plastica::fuzz
