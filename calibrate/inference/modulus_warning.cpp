#include "calibrate/inference/modulus_warning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {

std::string modulus_warning(const Target& target, std::span<const FittedParameter> parameters) {
  constexpr double kClose = 0.1, kErrors = 3.0;
  const Characteristics& c = target.characteristics;
  const auto p = std::ranges::find(parameters, "material.youngs_modulus", &FittedParameter::path);
  if (p == parameters.end() || p->role != ParameterRole::Free || !p->identified) return {};
  if (target.test != Test::Tension || !c.youngs_modulus || !c.youngs_modulus_stderr) return {};
  const double apart = std::abs(p->value - *c.youngs_modulus);
  const double error = std::hypot(p->scatter_error(), *c.youngs_modulus_stderr);
  if (apart <= std::max(kClose * *c.youngs_modulus, kErrors * error)) return {};
  return fmt::format(
      "youngs_modulus = {:.4g} GPa is not the slope of the curve's elastic part, {:.4g} GPa: the "
      "law does not follow that part, or samples before it are not elastic",
      p->value / 1e9, *c.youngs_modulus / 1e9);
}

}  // namespace plastica::calibrate
