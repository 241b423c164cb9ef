#include "plastica/run/chain_motion_runner.hpp"

namespace plastica {

template std::unique_ptr<ChainProgram> make_motion_runner<chain::Spatial<double>, true>(
    const ChainModel&, const chain::View<chain::Spatial<double>>&);

}  // namespace plastica
