#include "plastica/run/plane_warning.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "plastica/model/check_value.hpp"
#include "plastica/model/choose_level.hpp"

namespace plastica {
namespace {

/// Of the beam's length: rounding that does not grow stays far below.
constexpr double kGrown = 1e-8;

}  // namespace

std::optional<std::string> plane_warning(const Scene& scene, const SolverOptions& solver,
                                         Level level, const Response& response) {
  if (level != Level::Spatial || solver.analysis != Analysis::Statics || response.critical) {
    return {};
  }
  SolverOptions any_level = solver;
  any_level.level = Level::Auto;
  const LevelChoice least = choose_level(scene, any_level);
  if (least.level != Level::Planar) return {};
  const std::size_t across = least.bending == BendingAxis::X ? 0 : 1;
  const std::vector<double>& position = response.chain.position;
  double farthest = 0.0;
  for (std::size_t k = across; k < position.size(); k += 3) {
    if (std::isfinite(position[k])) farthest = std::max(farthest, std::fabs(position[k]));
  }
  if (!(farthest > kGrown * scene.beam.length)) return {};
  return fmt::format(
      "nothing acts across the plane, yet the beam leaves it by {} m: it hardly resists that, so "
      "that rounding grows, and how far depends on the steps. A real beam is never straight and "
      "leaves it earlier: add a small force across, or the imperfection that it has",
      model_detail::figure(farthest));
}

}  // namespace plastica
