#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plastica/model/choose_level.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::model_detail {

/// A history that is smooth, as a sine, and the shortest period in it [s]: that of a sine of the
/// same range and the same largest curvature.
struct HistoryPeriod {
  double period = 0.0;
  std::string name{};  ///< "load[2].history"
};
/// The shortest of a scene's smooth histories; empty if it has none.
std::optional<HistoryPeriod> shortest_history(const Scene& scene);

/// The part of `scene_warnings` that only dynamics have.
std::vector<std::string> motion_warnings(const Scene& scene, const SolverOptions& options,
                                         const LevelChoice& level, const SectionProperties& section,
                                         std::span<const double> ends);

}  // namespace plastica::model_detail
