#define PLASTICA_KERNEL_ISA kernels_baseline
#include "plastica/solve/lane_motion_make.hpp"

namespace plastica::solve {

constinit const LaneNewtonTable kBaselineNewton = newton_table();
constinit const LaneMotionTable kBaselineMotion = motion_table();

}  // namespace plastica::solve
