#pragma once

namespace plastica::theory {

/// How the two ends of a beam are held, the first named at x = 0.
enum class BeamEnds {
  ClampedFree,
  ClampedPinned,
  ClampedClamped,
  PinnedPinned,
  FreeFree,
};

}  // namespace plastica::theory
