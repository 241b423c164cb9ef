#pragma once

#include <string>

namespace plastica::io {

/// Writes into a PNG how many of its dots lie in an inch, so that programs that lay out pages take
/// it at its size; gnuplot says nothing of it.
/// Source: W3C, Portable Network Graphics (PNG) Specification, second edition (2003), 11.3.5.3.
/// @param png             a whole picture that does not say so yet
/// @param dots_per_inch   > 0
/// @throws MachineError if it does not begin as a PNG does
void set_png_resolution(std::string& png, double dots_per_inch);

}  // namespace plastica::io
