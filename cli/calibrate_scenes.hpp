#pragma once

#include "cli/calibrate_arguments.hpp"

namespace plastica::cli {

/// `plastica calibrate` of a fit file whose targets name scenes. @return the exit code
int calibrate_scenes(const CalibrateArguments& arguments);

}  // namespace plastica::cli
