#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "plastica/io/output_file.hpp"
#include "plastica/report/plot_script.hpp"

namespace plastica::report {

/// Refuses an output of no kind before any work is done. @throws InputError that names the option
void check_picture_output(const std::string& output, std::string_view option = "--output");

/// Draws and writes a picture; a file is replaced as a whole or left alone.
/// @param output  a path that ends in .svg, .png, .pdf, or .gp for the script with its data; "-"
///                for a picture of characters
/// @param standard_output  where a picture of characters goes, 79 columns wide; narrower where the
///                         environment variable COLUMNS says 40 … 79
/// @throws InputError for an output of another kind; MachineError if gnuplot is missing or fails,
///         or the file cannot be written
void draw_picture(const PlotScript& script, const std::string& output,
                  std::ostream& standard_output, io::Overwrite overwrite = io::Overwrite::Allowed);

}  // namespace plastica::report
