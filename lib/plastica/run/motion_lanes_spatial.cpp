#include "plastica/run/motion_lanes_make.hpp"

namespace plastica {

std::unique_ptr<LaneProgram> make_spatial_motion_lanes(const ChainModel& model) {
  const auto& table = solve::lane_motion(resolved(model.options.isa));
  const auto law = static_cast<std::size_t>(*lane_law(model));
  return std::make_unique<MotionLanes<chain::Spatial<double>>>(model, table.spatial[law]);
}

}  // namespace plastica
