#include "plastica/solve/lane_newton.hpp"

#include <cassert>

namespace plastica::solve {

LaneNewton::~LaneNewton() = default;

const LaneNewtonTable& lane_newton(InstructionSet level) {
  assert(level != InstructionSet::Auto);
#if defined(PLASTICA_WIDE_KERNELS)
  if (level == InstructionSet::Avx512) return kAvx512Newton;
  if (level == InstructionSet::Avx2) return kAvx2Newton;
#endif
  static_cast<void>(level);
  return kBaselineNewton;
}

}  // namespace plastica::solve
