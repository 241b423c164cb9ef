#define PLASTICA_KERNEL_ISA kernels_avx2
#include "plastica/solve/lane_newton_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kAvx2Newton = newton_table();

}  // namespace plastica::solve
