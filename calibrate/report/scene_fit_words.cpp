#include "calibrate/report/scene_fit_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "plastica/model/field.hpp"

namespace plastica::calibrate::report {

std::string short_name(std::string_view path) {
  return printable(path.substr(path.rfind('.') + 1));
}

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

std::vector<StrongCorrelation> strong_correlations(const SceneFitResult& result) {
  const std::size_t n = result.parameters.size();
  std::vector<StrongCorrelation> all;
  if (result.correlation.size() != n * n) return all;
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = a + 1; b < n; ++b) {
      const double value = result.correlation[a * n + b];
      if (std::fabs(value) > kStrongCorrelation) all.push_back({a, b, value});
    }
  }
  return all;
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
