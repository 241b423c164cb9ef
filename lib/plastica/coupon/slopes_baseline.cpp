#define PLASTICA_KERNEL_ISA slopes_baseline
#include "plastica/coupon/slope_kernel_make.hpp"

namespace plastica::coupon {

void slopes_baseline_kernel(const SlopesRun& run) { follow_any(run); }

}  // namespace plastica::coupon
