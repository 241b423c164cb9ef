#include "calibrate/problem/given_weights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace plastica::calibrate {

double given_weight(const std::vector<WeightStep>& steps, double strain) {
  const auto after =
      std::upper_bound(steps.begin(), steps.end(), std::fabs(strain),
                       [](double size, const WeightStep& step) { return size < step.from; });
  return after == steps.begin() ? 1.0 : std::prev(after)->weight;
}

bool any_weight(const std::vector<WeightStep>& steps, const Curve& curve) {
  return std::any_of(curve.strain.begin(), curve.strain.end(),
                     [&](double strain) { return given_weight(steps, strain) > 0.0; });
}

void check_weights(const FitOptions& options) {
  if (options.weights.empty()) return;
  if (options.objective != Objective::LeastSquares) {
    throw InputError({}, "fit.weights", "", "go with the objective least squares alone");
  }
  for (std::size_t i = 0; i < options.weights.size(); ++i) {
    const WeightStep& step = options.weights[i];
    const auto require = [&](bool holds, const char* name, double value, const char* rule) {
      if (holds) return;
      throw InputError({}, fmt::format("fit.weights[{}].{}", i + 1, name),
                       fmt::format("{:g}", value), rule);
    };
    require(step.from >= 0.0, "from", step.from, "must be at least 0");
    require(std::isfinite(step.from), "from", step.from, "must be finite");
    require(step.weight >= 0.0, "weight", step.weight, "must be at least 0");
    require(std::isfinite(step.weight), "weight", step.weight, "must be finite");
    require(i == 0 || step.from > options.weights[i - 1].from, "from", step.from,
            "must be above that of the step before");
  }
}

}  // namespace plastica::calibrate
