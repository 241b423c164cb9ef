#pragma once

#include <string>

namespace plastica::testing {

/// A curve of 200 GPa that breaks at 2 % of permanent strain, with some roughness: columns
/// `Strain (%)` and `Stress (MPa)`.
/// @param yield   yield stress [MPa]
/// @param number  of the specimen; its roughness follows from it
/// @param step    of the strain [%]
std::string broken_curve(double yield = 350.0, int number = 0, double step = 0.02);

/// A fit file for such curves, with the usual parameters.
/// @param files  value of the key `files`: "\"a.csv\""
/// @param fit    lines of [fit]
std::string fit_file(const std::string& files, const std::string& fit = "");

}  // namespace plastica::testing
