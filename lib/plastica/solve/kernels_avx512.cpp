#define PLASTICA_KERNEL_ISA kernels_avx512
#include "plastica/solve/lane_motion_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kAvx512Newton = newton_table();
constinit const LaneMotionTable kAvx512Motion = motion_table();

}  // namespace plastica::solve
