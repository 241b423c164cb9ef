#pragma once

#include <string>
#include <vector>

#include "calibrate/result/result.hpp"

namespace plastica::calibrate::report {

/// What the word for the misfit means (`misfit_word`), in a plain clause: "ideal plasticity does
/// not describe this curve". Empty for a word that is none of "close", "fair" and "poor".
std::string misfit_meaning(const FitResult& result);

/// What a user may do about a fit that is not as it should be: one sentence each, none if all is
/// well.
std::vector<std::string> advice_for(const FitRecord& record);

}  // namespace plastica::calibrate::report
