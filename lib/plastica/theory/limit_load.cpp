#include "plastica/theory/limit_load.hpp"

#include <cmath>

#include "plastica/base/domain.hpp"

namespace plastica::theory {
namespace {

/// Hinges that turn with the part of the beam at one end: that under the load, and its own.
double hinges(bool clamped) { return clamped ? 2.0 : 1.0; }

}  // namespace

double limit_force(BeamEnds ends, double plastic_moment, double length, double position) {
  require_domain(ends != BeamEnds::FreeFree && position > 0.0,
                 "ends != FreeFree && position > 0.0");
  if (ends == BeamEnds::ClampedFree) return plastic_moment / position;
  require_domain(position < length, "position < length");
  return plastic_moment * (hinges(ends != BeamEnds::PinnedPinned) / position +
                           hinges(ends == BeamEnds::ClampedClamped) / (length - position));
}

double limit_distributed(BeamEnds ends, double plastic_moment, double length) {
  require_domain(ends != BeamEnds::FreeFree, "ends != FreeFree");
  const double unit = plastic_moment / (length * length);
  if (ends == BeamEnds::ClampedFree) return 2.0 * unit;
  const double roots = std::sqrt(hinges(ends != BeamEnds::PinnedPinned)) +
                       std::sqrt(hinges(ends == BeamEnds::ClampedClamped));
  return 2.0 * roots * roots * unit;
}

}  // namespace plastica::theory
