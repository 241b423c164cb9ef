#include "calibrate/result/scene_fit_record.hpp"

#include <utility>

namespace plastica::calibrate {

int SceneFitResult::evaluations() const {
  int sum = 0;
  for (const SceneStart& start : starts) sum += start.evaluations;
  return sum;
}

SceneFitRecord record_of(const SceneFitCase& one, SceneFitResult result) {
  SceneFitRecord record;
  record.name = one.name;
  for (const WeightedTarget& weighted : one.targets) {
    record.targets.push_back(weighted.target);
    record.weights.push_back(weighted.weight);
  }
  record.result = std::move(result);
  std::vector<std::string> warnings;
  for (const SceneTarget& target : record.targets) {
    for (const std::string& warning : target.warnings) {
      warnings.push_back(target.name + ": " + warning);
    }
  }
  std::vector<std::string>& all = record.result.warnings;
  all.insert(all.begin(), warnings.begin(), warnings.end());
  return record;
}

}  // namespace plastica::calibrate
