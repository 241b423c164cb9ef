#include "plastica/base/instruction_set.hpp"

#include <string>

#include "plastica/base/check.hpp"

namespace plastica {

bool has_instruction_set(InstructionSet level) {
#if defined(PLASTICA_WIDE_KERNELS)
  switch (level) {
    case InstructionSet::Avx2:
      return static_cast<bool>(__builtin_cpu_supports("avx2")) &&
             static_cast<bool>(__builtin_cpu_supports("fma"));
    case InstructionSet::Avx512:
      return has_instruction_set(InstructionSet::Avx2) &&
             static_cast<bool>(__builtin_cpu_supports("avx512f")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512dq")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512bw")) &&
             static_cast<bool>(__builtin_cpu_supports("avx512vl"));
    default: return true;
  }
#else
  return level == InstructionSet::Auto || level == InstructionSet::Baseline;
#endif
}

InstructionSet resolved(InstructionSet level) {
  if (level == InstructionSet::Auto) {
    for (const InstructionSet wide : {InstructionSet::Avx512, InstructionSet::Avx2}) {
      if (has_instruction_set(wide)) return wide;
    }
    return InstructionSet::Baseline;
  }
  if (!has_instruction_set(level)) {
    throw InputError({}, "solver.isa", name_of(level), "is not what this processor has");
  }
  return level;
}

std::string_view name_of(InstructionSet level) {
  return kInstructionSets[static_cast<std::size_t>(level)];
}

}  // namespace plastica
