#include "calibrate/problem/modulus_prior.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {
namespace {

/// Errors of a slope that its scatter does not show, as a fraction of it.
constexpr double kHidden = 0.02;

}  // namespace

std::optional<ModulusPrior> modulus_prior(const Target& target, const FitOptions& options) {
  const Characteristics& c = target.characteristics;
  const bool is_measured = target.test == Test::Tension && c.modulus_method == "regression" &&
                           c.youngs_modulus && c.youngs_modulus_stderr;
  const bool is_free = std::ranges::any_of(options.parameters, [](const Parameter& p) {
    return p.role == ParameterRole::Free && p.field->material == MaterialField::YoungsModulus;
  });
  if (!options.modulus_prior || !is_measured || !is_free) return std::nullopt;
  return ModulusPrior{*c.youngs_modulus,
                      std::hypot(*c.youngs_modulus_stderr, kHidden * *c.youngs_modulus), 0.0};
}

}  // namespace plastica::calibrate
