#pragma once

#include <tuple>

namespace plastica::sweeps {

/// What damps the joints of an exported beam.
enum class EngineDamping {
  Scene,      ///< as the scene's joints are
  None,       ///< nothing, as in the scene
  Numerical,  ///< a tenth of the step times the stiffness, where the scene damps nothing
};

/// How an engine runs a beam.
struct EngineSetting {
  EngineDamping damping = EngineDamping::None;
  int segments = 4;
  int steps = 1;  ///< from one sample of the scene to the next

  friend bool operator==(const EngineSetting&, const EngineSetting&) = default;
  friend bool operator<(const EngineSetting& a, const EngineSetting& b) {
    return std::tie(a.damping, a.segments, a.steps) < std::tie(b.damping, b.segments, b.steps);
  }
};

}  // namespace plastica::sweeps
