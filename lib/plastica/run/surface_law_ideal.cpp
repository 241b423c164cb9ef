#include "plastica/run/surface_law_make.hpp"

namespace plastica {

PLASTICA_YIELD_SURFACES(double, law::IdealPlastic<double>);
PLASTICA_YIELD_SURFACES(float, law::IdealPlastic<float>);

}  // namespace plastica
