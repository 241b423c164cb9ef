#pragma once

#include <string>

/// The colours of plastic strain in pictures; not installed.
namespace plastica::report {

/// The colour of a fraction of the largest plastic strain, as a number 0xRRGGBB.
/// @param light  fraction of its brightness, 0 … 1
double color_at(double fraction, double light);

/// The command that sets the same colours for gnuplot's bar of colours.
std::string strain_palette();

}  // namespace plastica::report
