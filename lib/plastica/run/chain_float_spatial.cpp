#include "plastica/run/chain_float.hpp"
#include "plastica/run/chain_laws_make.hpp"
#include "plastica/run/chain_motion_runner.hpp"
#include "plastica/run/chain_runner_make.hpp"

namespace plastica {

PLASTICA_MAKE_JOINTS(chain::Spatial<float>, false);

std::unique_ptr<ChainProgram> make_float_program(const ChainModel& model,
                                                 const chain::View<chain::Spatial<float>>& view) {
  return make_program<chain::Spatial<float>, false>(model, view);
}

}  // namespace plastica
