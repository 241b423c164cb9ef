#pragma once

#include <string>
#include <vector>

namespace plastica::calibrate {

/// The table [fit.parameters] of a fit of bare files: the usual ones, some of which are fixed; not
/// installed.
/// @param fixed  as `--fix` takes them: "youngs_modulus=200 GPa"
/// @throws InputError for what is no such text, and if none is left to fit
std::string parameters_text(const std::vector<std::string>& fixed);

}  // namespace plastica::calibrate
