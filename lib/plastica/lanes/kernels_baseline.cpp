#define PLASTICA_KERNEL_ISA kernels_baseline
#include "plastica/lanes/kernel_table_make.hpp"

namespace plastica::lanes {

constinit const KernelTable kBaselineKernels{kernels_of<double>(), kernels_of<float>()};

}  // namespace plastica::lanes
