#include "calibrate/result/scene_fit_record.hpp"

#include <utility>

namespace plastica::calibrate {

SceneFitRecord record_of(const SceneFitCase& one, SceneFitResult result) {
  SceneFitRecord record;
  record.name = one.name;
  for (const ScenePart& part : one.parts) {
    record.targets.push_back(part.target);
    record.weights.push_back(part.weight);
  }
  record.result = std::move(result);
  return record;
}

}  // namespace plastica::calibrate
