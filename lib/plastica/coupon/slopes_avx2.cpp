#define PLASTICA_KERNEL_ISA slopes_avx2
#include "plastica/coupon/slope_kernel_make.hpp"

namespace plastica::coupon {

void slopes_avx2_kernel(const SlopesRun& run) { follow_any(run); }

}  // namespace plastica::coupon
