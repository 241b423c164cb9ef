#include "plastica/run/path_lanes_make.hpp"

namespace plastica {

std::unique_ptr<LaneProgram> make_planar_path_lanes(const ChainModel& model) {
  using L = chain::Planar<double>;
  const auto& table = solve::lane_newton(resolved(model.options.isa));
  return std::make_unique<PathLanes<L>>(model, lane_newton_of(table.planar, model));
}

}  // namespace plastica
