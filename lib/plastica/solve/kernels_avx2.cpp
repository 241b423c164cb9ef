#define PLASTICA_KERNEL_ISA kernels_avx2
#include "plastica/solve/lane_motion_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kAvx2Newton = newton_table();
constinit const LaneMotionTable kAvx2Motion = motion_table();

}  // namespace plastica::solve
