#include "plastica/base/version.hpp"

namespace plastica {

std::string_view version() { return PLASTICA_VERSION; }

}  // namespace plastica
