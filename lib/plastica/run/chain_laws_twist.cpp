#include "plastica/run/chain_laws_make.hpp"

namespace plastica {

PLASTICA_MAKE_JOINTS(chain::Twist<double>, false);

}  // namespace plastica
