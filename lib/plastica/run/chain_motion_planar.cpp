#include "plastica/run/chain_motion_runner.hpp"

namespace plastica {

template std::unique_ptr<ChainProgram> make_motion_runner<chain::Planar<double>, false>(
    const ChainModel&, const chain::View<chain::Planar<double>>&);

}  // namespace plastica
