#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "calibrate/fit/result.hpp"
#include "plastica/model/material.hpp"

namespace plastica::calibrate::report {

/// "ideal plasticity", or what else was fitted.
std::string_view name_of_law(HardeningLaw law);

/// What the word for the misfit means, in a plain clause: "ideal plasticity cannot follow this
/// curve". Empty for a word that is none of "close", "fair" and "poor".
std::string misfit_meaning(const FitResult& result, HardeningLaw law);

/// What a user may do about a fit that is not as it should be: one sentence each, none if all is
/// well.
std::vector<std::string> advice_for(const FitRecord& record, HardeningLaw law);

}  // namespace plastica::calibrate::report
