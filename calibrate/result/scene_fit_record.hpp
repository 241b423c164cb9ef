#pragma once

#include <limits>
#include <string>
#include <vector>

#include "calibrate/fit/scene_fit.hpp"

namespace plastica::calibrate {

/// One fit of several that are run together.
struct SceneFitCase {
  std::string name;  ///< the target's; of a fit that shares its parameters the file's
  std::vector<WeightedTarget> targets;
};

/// One fit through scenes, what it was held against and what came out: what a file holds of it, and
/// reports and pictures are made of.
struct SceneFitRecord {
  /// Unique in a file, or with laws of their own: the target's, or the file's of a joint fit.
  std::string name;
  std::vector<SceneTarget> targets;  ///< as `SceneFitResult::targets`
  std::vector<double> weights;       ///< of these
  SceneFitResult result;
  /// Time that it took; of laws that are compared without what is made of the advised one alone
  /// [s]. NaN: not known.
  double seconds = std::numeric_limits<double>::quiet_NaN();
};

/// What a record is called, alike for all kinds of records.
inline const std::string& name_of(const SceneFitRecord& record) { return record.name; }

/// What there is to be said of a fit, but for its time.
SceneFitRecord record_of(const SceneFitCase& one, SceneFitResult result);

}  // namespace plastica::calibrate
