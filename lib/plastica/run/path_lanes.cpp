#include "plastica/run/path_lanes.hpp"

#include "plastica/base/instruction_set.hpp"

namespace plastica {

bool continues_in_lanes(const ChainModel& model) {
  return model.options.analysis == Analysis::Statics && why_alone(model).empty();
}

bool same_path_lanes(const ChainModel& a, const ChainModel& b) {
  return continues_in_lanes(a) && continues_in_lanes(b) && same_shape(a, b);
}

std::size_t fewest_paths(const ChainModel& model) {
  switch (resolved(model.options.isa)) {
    case InstructionSet::Avx512: return 2;
    case InstructionSet::Avx2: return model.level == Level::Planar ? 6 : 5;
    default: return solve::kPathLanes;  // as fast as one by one, if all are full
  }
}

std::unique_ptr<LaneProgram> make_path_lanes(const ChainModel& model) {
  if (model.level == Level::Planar) return make_planar_path_lanes(model);
  return make_spatial_path_lanes(model);
}

}  // namespace plastica
