#pragma once

#include <string>
#include <vector>

#include "calibrate/fit/result.hpp"

namespace plastica::calibrate::report {

/// What the word for the misfit means: a plain sentence for the report.
std::string misfit_meaning(const FitResult& result);

/// What a user may do about a fit that is not as it should be: one sentence each, none if all is
/// well.
std::vector<std::string> advice_for(const FitRecord& record);

}  // namespace plastica::calibrate::report
