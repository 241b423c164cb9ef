#include <cassert>

#include "plastica/lanes/kernel_table.hpp"

namespace plastica::lanes {

const KernelTable& kernels(InstructionSet level) {
  assert(level != InstructionSet::Auto);
#if defined(PLASTICA_WIDE_KERNELS)
  if (level == InstructionSet::Avx512) return kAvx512Kernels;
  if (level == InstructionSet::Avx2) return kAvx2Kernels;
#endif
  static_cast<void>(level);
  return kBaselineKernels;
}

}  // namespace plastica::lanes
