#include "plastica/law/rated.hpp"
#include "plastica/run/surface_law_make.hpp"

namespace plastica {

PLASTICA_YIELD_SURFACES(double, law::Rated<law::VoceChaboche<double>>);
PLASTICA_YIELD_SURFACES(double, law::Rated<law::Multilinear<double>>);

}  // namespace plastica
