#define PLASTICA_KERNEL_ISA kernels_baseline
#include "plastica/solve/lane_newton_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kBaselineNewton = newton_table();

}  // namespace plastica::solve
