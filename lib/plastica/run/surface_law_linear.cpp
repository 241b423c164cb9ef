#include "plastica/run/surface_law_make.hpp"

namespace plastica {

PLASTICA_YIELD_SURFACES(double, law::LinearHardening<double>);

}  // namespace plastica
