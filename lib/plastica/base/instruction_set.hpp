#pragma once

#include <array>
#include <string_view>

namespace plastica {

/// Vector instructions that kernels are compiled for; each level has bits of its own.
enum class InstructionSet {
  Auto,      ///< the widest one that the processor has
  Baseline,  ///< what every 64-bit processor has: 16 bytes at a time on x86 (SSE2)
  Avx2,      ///< 32 bytes, fused multiply-adds
  Avx512     ///< 64 bytes, fused multiply-adds
};

/// The words of files and of `--isa`, in the order of the levels.
inline constexpr std::array<std::string_view, 4> kInstructionSets{"auto", "baseline", "avx2",
                                                                  "avx512"};

/// Whether this processor, and this build, have a level.
bool has_instruction_set(InstructionSet level);

/// The level itself, or for Auto the widest that there is.
/// @throws InputError naming `solver.isa` if this processor does not have it
InstructionSet resolved(InstructionSet level);

/// Its word.
std::string_view name_of(InstructionSet level);

}  // namespace plastica
