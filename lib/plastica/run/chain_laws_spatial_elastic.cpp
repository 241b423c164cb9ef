#include "plastica/run/chain_laws_make.hpp"

namespace plastica {

PLASTICA_MAKE_JOINTS(chain::Spatial<double>, true);

}  // namespace plastica
