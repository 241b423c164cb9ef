#include <algorithm>
#include <cmath>
#include <limits>

#include "calibrate/trial/scene_model.hpp"

/// The permanent strains that a break limit is held against.
namespace plastica::calibrate {

double SceneModel::strain_of(const Response& response, const std::vector<bool>& limited,
                             std::size_t sample) const {
  if (strain_probe_) return std::fabs(response.probes[*strain_probe_][sample]);
  const std::size_t joints = response.chain.joints;
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t j = 0; j < joints; ++j) {
    if (limited[j]) {
      largest = std::fmax(largest, response.chain.plastic_strain[sample * joints + j]);
    }
  }
  return largest;
}

/// Between samples on a straight line.
double SceneModel::strain_at(const Response& response, const std::vector<double>& path,
                             const std::vector<bool>& limited, double at) const {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  if (path.size() < 2) return kNowhere;
  const double slack = kRounding * std::max(std::abs(path.front()), std::abs(path.back()));
  if (at < path.front() - slack || at > path.back() + slack) return kNowhere;
  const auto above = std::lower_bound(path.begin() + 1, path.end() - 1, at);
  const auto k = static_cast<std::size_t>(above - path.begin());
  const double fraction = (at - path[k - 1]) / (path[k] - path[k - 1]);
  const double low = strain_of(response, limited, k - 1);
  return low + fraction * (strain_of(response, limited, k) - low);
}

double SceneModel::largest_strain(const Response& response, const std::vector<double>& path,
                                  const std::vector<bool>& limited, double until) const {
  double largest = strain_at(response, path, limited, until);
  for (std::size_t i = 0; i < path.size() && path[i] <= until; ++i) {
    largest = std::fmax(largest, strain_of(response, limited, i));
  }
  return largest;
}

void SceneModel::set_strain(const Response& response, const std::vector<double>& path,
                            const std::vector<bool>& limited, SceneCurve& curve) const {
  const auto at = [&](double place) { return strain_at(response, path, limited, place); };
  const auto up_to = [&](double place) { return largest_strain(response, path, limited, place); };
  const double last = is_driven(target_.kind) ? static_cast<double>(target_.abscissa.size() - 1)
                                              : target_.abscissa.back();
  if (!target_.broke) {
    curve.strain.at = at(last);
    curve.strain.survived = up_to(last);
    return;
  }
  if (is_driven(target_.kind)) {
    curve.strain = {at(last + 0.5), at(last), at(last + 1.0), up_to(last)};
    return;
  }
  const SceneBreak& broke = *target_.broke;
  const double intact = broke.at - broke.half_interval;
  curve.strain = {at(broke.at), at(intact), at(broke.at + broke.half_interval), up_to(intact)};
}
}  // namespace plastica::calibrate
