#include "calibrate/problem/rising_ideal.hpp"

#include <algorithm>
#include <cmath>

namespace plastica::calibrate {

std::optional<RisingIdeal> RisingIdeal::of(std::span<const double> strain,
                                           std::span<const double> stress,
                                           std::span<const double> weight) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (stress.empty() || !std::ranges::is_sorted(strain) || !std::ranges::all_of(strain, finite) ||
      !std::ranges::all_of(stress, finite) || !std::ranges::all_of(weight, finite)) {
    return std::nullopt;
  }
  const std::size_t n = stress.size();
  RisingIdeal made;
  made.strain_.assign(strain.begin(), strain.begin() + static_cast<std::ptrdiff_t>(n));
  made.last_ = strain.back();
  made.elastic_.resize(n + 1);
  made.plateau_.resize(n + 1);
  const auto add_elastic = [&](std::size_t i) {
    const Term& before = made.elastic_[i];
    const double off = stress[i] - before.best * strain[i];
    Term& now = made.elastic_[i + 1];
    now.weight = before.weight + weight[i] * strain[i] * strain[i];
    // Divided once, beside the recursion: what the next sample waits for is two products.
    const bool has_slope = now.weight > 0.0;
    const double inverse = has_slope ? 1.0 / now.weight : 0.0;
    now.best = before.best + weight[i] * strain[i] * inverse * off;
    now.residual =
        before.residual + weight[i] * off * off * (has_slope ? before.weight * inverse : 1.0);
  };
  const auto add_plateau = [&](std::size_t i) {
    const Term& behind = made.plateau_[i + 1];
    const double off = stress[i] - behind.best;
    Term& now = made.plateau_[i];
    now.weight = behind.weight + weight[i];
    if (!(now.weight > 0.0)) return;
    const double inverse = 1.0 / now.weight;
    now.best = behind.best + weight[i] * inverse * off;
    now.residual = behind.residual + weight[i] * off * off * (behind.weight * inverse);
  };
  // Each waits for its own sample before: side by side they wait together.
  for (std::size_t i = 0; i < n; ++i) {
    add_elastic(i);
    add_plateau(n - 1 - i);
  }
  return made;
}

std::optional<RisingIdeal::Sum> RisingIdeal::sum(double stiffness, double yield) const {
  if (stiffness * strain_.front() < -yield) return std::nullopt;
  const auto yields = std::partition_point(
      strain_.begin(), strain_.end(), [&](double strain) { return stiffness * strain <= yield; });
  const auto k = static_cast<std::size_t>(yields - strain_.begin());
  const Term& elastic = elastic_[k];
  const Term& plateau = plateau_[k];
  const double stiffer = stiffness - elastic.best;
  const double higher = yield - plateau.best;
  return Sum{.squares = elastic.residual + elastic.weight * stiffer * stiffer + plateau.residual +
                        plateau.weight * higher * higher,
             .by_stiffness = 2.0 * elastic.weight * stiffer,
             .by_yield = 2.0 * plateau.weight * higher,
             .stiffness_normal = elastic.weight,
             .yield_normal = plateau.weight};
}

RisingIdeal::Permanent RisingIdeal::permanent(double stiffness, double yield) const {
  if (stiffness * last_ <= yield) return {};
  return {.strain = last_ - yield / stiffness,
          .by_stiffness = yield / (stiffness * stiffness),
          .by_yield = -1.0 / stiffness};
}

}  // namespace plastica::calibrate
