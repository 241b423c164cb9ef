#include "plastica/run/chain_motion_runner.hpp"

namespace plastica {

template std::unique_ptr<ChainProgram> make_motion_runner<chain::Twist<double>, false>(
    const ChainModel&, const chain::View<chain::Twist<double>>&);

}  // namespace plastica
