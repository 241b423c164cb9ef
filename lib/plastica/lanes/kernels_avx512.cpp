#define PLASTICA_KERNEL_ISA kernels_avx512
#include "plastica/lanes/kernel_table_make.hpp"

namespace plastica::lanes {

constinit const KernelTable kAvx512Kernels{kernels_of<double>(), kernels_of<float>()};

}  // namespace plastica::lanes
