#include "plastica/base/version.hpp"

namespace plastica {

std::string_view version() { return PLASTICA_VERSION; }

std::string_view instruction_set() { return "baseline"; }

}  // namespace plastica
