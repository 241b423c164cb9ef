#include "cli/isa_option.hpp"

#include <algorithm>
#include <vector>

#include "plastica/base/check.hpp"

namespace plastica::cli {

void add_isa_option(CLI::App& sub, std::string& isa) {
  const std::vector<std::string> words(kInstructionSets.begin(), kInstructionSets.end());
  sub.add_option("--isa", isa,
                 "vector instructions of articulated schemes, which have bits of their own at each "
                 "level, and of batches at rest, which have not; in place of solver.isa")
      ->check(CLI::IsMember(words));
}

void take_isa(const std::string& isa, SolverOptions& options) {
  if (isa.empty()) return;
  const auto word = std::find(kInstructionSets.begin(), kInstructionSets.end(), isa);
  options.isa = static_cast<InstructionSet>(word - kInstructionSets.begin());
  if (!has_instruction_set(options.isa)) {
    throw InputError({}, "--isa", isa, "is not what this processor has");
  }
}

}  // namespace plastica::cli
