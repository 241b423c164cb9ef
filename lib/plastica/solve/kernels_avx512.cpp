#define PLASTICA_KERNEL_ISA kernels_avx512
#include "plastica/solve/lane_newton_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kAvx512Newton = newton_table();

}  // namespace plastica::solve
