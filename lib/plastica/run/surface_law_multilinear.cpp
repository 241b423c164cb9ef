#include "plastica/run/surface_law_make.hpp"

namespace plastica {

PLASTICA_SURFACE_LAWS(law::Multilinear<double>);

}  // namespace plastica
