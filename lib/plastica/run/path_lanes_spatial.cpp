#include "plastica/run/path_lanes_make.hpp"

namespace plastica {

std::unique_ptr<LaneProgram> make_spatial_path_lanes(const ChainModel& model) {
  using L = chain::Spatial<double>;
  const auto& table = solve::lane_newton(resolved(model.options.isa));
  return std::make_unique<PathLanes<L>>(model, lane_newton_of(table.spatial, model));
}

}  // namespace plastica
