#include "plastica/model/shared_moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/model/beam_axis.hpp"

namespace plastica::model_detail {

bool shares_moments(const Scene& scene, std::span<const double> ends) {
  constexpr std::array<double, 3> kNone{};
  constexpr double kSamePlace = 1e-9;  // as chain/builder.hpp has it
  return std::ranges::any_of(scene.supports, [&](const Support& support) {
    if (support.to || support.rotational_stiffness == kNone) return false;
    const double at = fraction_of(support.at, ends);
    return at > 0.0 && at < 1.0 && std::ranges::any_of(scene.loads, [&](const Load& load) {
             return !load.to && load.moment != kNone &&
                    std::fabs(fraction_of(load.at, ends) - at) < kSamePlace;
           });
  });
}

}  // namespace plastica::model_detail
