#include "calibrate/problem/weighed_priors.hpp"

namespace plastica::calibrate {

WeighedPriors priors_of(const FitOptions& options, const std::optional<ModulusPrior>& slope) {
  WeighedPriors priors;
  for (const Parameter& p : options.parameters) {
    if (p.role != ParameterRole::Free) continue;
    if (p.prior) priors.all.push_back({p.field, *p.prior});
    if (slope && p.field->material == MaterialField::YoungsModulus) {
      priors.all.push_back({p.field, {slope->mean, slope->standard_deviation}, false});
    }
  }
  return priors;
}

}  // namespace plastica::calibrate
