#include "calibrate/report/scene_fit_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/model/field.hpp"

namespace plastica::calibrate::report {

std::string abscissa_text(const SceneTarget& target) {
  switch (target.kind) {
    case Abscissa::Probe: return printable(target.abscissa_probe);
    case Abscissa::Time: return "time";
    case Abscissa::Support: return fmt::format("support {}", target.driven + 1);
    case Abscissa::Load: return fmt::format("load {}", target.driven + 1);
    case Abscissa::Strain: return "strain";
  }
  return {};
}

bool has_several_laws(const SceneFitResult& result) {
  return std::ranges::any_of(result.targets,
                             [&](const TargetFit& each) { return each.law != result.law; });
}

std::string laws_text(const SceneFitResult& result) {
  std::vector<Law> laws{result.law};
  std::string text(name_of(result.law));
  for (const TargetFit& each : result.targets) {
    if (std::ranges::find(laws, each.law) != laws.end()) continue;
    laws.push_back(each.law);
    text += fmt::format(", {}", name_of(each.law));
  }
  return text;
}

std::vector<double> sorted_costs(const SceneFitResult& result) {
  std::vector<double> costs;
  for (const SceneStart& start : result.starts) {
    if (std::isfinite(start.cost)) costs.push_back(start.cost);
  }
  std::ranges::sort(costs);
  return costs;
}

std::size_t count_of_best(const std::vector<double>& costs) {
  return static_cast<std::size_t>(std::ranges::count_if(
      costs, [&](double cost) { return cost <= costs.front() * (1.0 + 1e-3); }));
}

}  // namespace plastica::calibrate::report
