#include "plastica/model/shared_moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plastica/model/beam_axis.hpp"

namespace plastica::model_detail {

bool shares_moment(const Scene& scene, const Load& load, std::span<const double> ends) {
  constexpr std::array<double, 3> kNone{};
  constexpr double kSamePlace = 1e-9;  // as chain/builder.hpp has it
  if (load.to || load.moment == kNone) return false;
  const double at = fraction_of(load.at, ends);
  return at > 0.0 && at < 1.0 && std::ranges::any_of(scene.supports, [&](const Support& support) {
           return !support.to && support.rotational_stiffness != kNone &&
                  std::fabs(fraction_of(support.at, ends) - at) < kSamePlace;
         });
}

bool shares_moments(const Scene& scene, std::span<const double> ends) {
  return std::ranges::any_of(scene.loads,
                             [&](const Load& load) { return shares_moment(scene, load, ends); });
}

}  // namespace plastica::model_detail
