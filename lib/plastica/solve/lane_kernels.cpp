#include <cassert>

#include "plastica/solve/lane_motion.hpp"
#include "plastica/solve/lane_newton.hpp"

namespace plastica::solve {

LaneNewton::~LaneNewton() = default;
LaneMotion::~LaneMotion() = default;

const LaneNewtonTable& lane_newton(InstructionSet level) {
  assert(level != InstructionSet::Auto);
#if defined(PLASTICA_WIDE_KERNELS)
  if (level == InstructionSet::Avx512) return kAvx512Newton;
  if (level == InstructionSet::Avx2) return kAvx2Newton;
#endif
  static_cast<void>(level);
  return kBaselineNewton;
}

const LaneMotionTable& lane_motion(InstructionSet level) {
  assert(level != InstructionSet::Auto);
#if defined(PLASTICA_WIDE_KERNELS)
  if (level == InstructionSet::Avx512) return kAvx512Motion;
  if (level == InstructionSet::Avx2) return kAvx2Motion;
#endif
  static_cast<void>(level);
  return kBaselineMotion;
}

}  // namespace plastica::solve
