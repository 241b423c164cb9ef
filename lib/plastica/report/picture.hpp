#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "plastica/io/output_file.hpp"
#include "plastica/report/plot_script.hpp"

namespace plastica::report {

/// Refuses an output of no kind before any work is done. @throws InputError that names the option
void check_picture_output(const std::string& output, std::string_view option = "--output");

/// What a picture is drawn on.
/// @param output  as for `draw_picture`
/// @param width   of the page, whose letters are of 8 points then [mm]; none: one for screens
Sheet sheet_of(const std::string& output, std::optional<double> width);

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
