#include "plastica/run/chain_runner_make.hpp"

namespace plastica {

template class ChainRunner<chain::Spatial<double>, false>;

}  // namespace plastica
