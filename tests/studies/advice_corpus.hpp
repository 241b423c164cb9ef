#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plastica/model/field.hpp"

namespace plastica::studies {

/// What a closed form says of a scene.
struct ClosedForm {
  /// Of `sweeps::Outcome`'s numbers ("limit load", "buckling factor 1"), or a probe's name: its
  /// last value.
  std::string of;
  double value = 0.0;  ///< [SI]
  /// What the closed form leaves out of the scene (large displacements, shear), over its value [1].
  double off = 0.0;
};

/// A scene on which advice is tried.
struct CorpusScene {
  std::string name;
  std::string group;  ///< "rest, elastic, plane": a row of the study's table
  Setup setup;
  std::optional<ClosedForm> truth{};
};

/// Scenes of their own, and those that are shipped: at rest and in motion, elastic, yielding and
/// breaking, in a plane and in space.
std::vector<CorpusScene> advice_corpus();

}  // namespace plastica::studies
