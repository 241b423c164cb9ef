#include "plastica/law/rated.hpp"
#include "plastica/run/surface_law_make.hpp"

namespace plastica {

PLASTICA_SURFACE_LAWS(law::Rated<law::VoceChaboche<double>>);
PLASTICA_SURFACE_LAWS(law::Rated<law::Multilinear<double>>);

}  // namespace plastica
