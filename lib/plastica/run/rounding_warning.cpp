#include "plastica/run/rounding_warning.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <fmt/format.h>

#include "plastica/model/check_value.hpp"

namespace plastica {
namespace {

/// Of the largest reaction: rounding below this part of it is not seen in its figures.
constexpr double kSmall = 1e-6;

/// Force and moment.
struct Sizes {
  double force = 0.0;   ///< [N]
  double moment = 0.0;  ///< [N m]
};

Sizes largest_reactions(const std::vector<double>& reaction) {
  Sizes largest;
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    double& size = i % 6 < 3 ? largest.force : largest.moment;
    size = std::max(size, std::fabs(reaction[i]));
  }
  return largest;
}

}  // namespace

std::vector<std::string> rounding_warnings(const Scene& scene, const Response& response) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  const Sizes largest = largest_reactions(response.chain.reaction);
  const double length = scene.beam.length;
  // Moments are forces on levers.
  const double moment = std::max(largest.moment, largest.force * length);
  std::vector<std::string> all;
  if (!(moment > 0.0)) return all;
  const auto note = [&](std::size_t support, double rounding, double reaction, const char* unit) {
    if (!(rounding > kSmall * reaction)) return;
    all.push_back(fmt::format(
        "support {}: its stiffness makes some {} {} of the rounding of double precision, where the "
        "largest reaction is {} {}: support it rigidly there, or by a softer spring",
        support + 1, model_detail::figure(rounding), unit, model_detail::figure(reaction), unit));
  };
  for (std::size_t k = 0; k < scene.supports.size(); ++k) {
    const Support& support = scene.supports[k];
    if (support.kind != SupportKind::Elastic) continue;
    const double along = support.to ? length : 1.0;  // of a bed, at most that of the whole beam
    const auto stiffest = [](const std::array<double, 3>& of) {
      return *std::max_element(of.begin(), of.end());
    };
    note(k, kEpsilon * length * along * stiffest(support.stiffness), largest.force, "N");
    note(k, kEpsilon * stiffest(support.rotational_stiffness), moment, "N m");
  }
  return all;
}

}  // namespace plastica
