#include "plastica/coupon/slope_kernel.hpp"

#include <cassert>

namespace plastica::coupon {

SlopeKernel slope_kernel(InstructionSet level) {
  assert(level != InstructionSet::Auto);
#if defined(PLASTICA_WIDE_KERNELS)
  if (level != InstructionSet::Baseline) return slopes_avx2_kernel;
#endif
  static_cast<void>(level);
  return slopes_baseline_kernel;
}

}  // namespace plastica::coupon
