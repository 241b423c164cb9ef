#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "calibrate/result/result.hpp"
#include "plastica/io/output_file.hpp"

namespace plastica::calibrate {

/// A picture that a file of fits can be drawn as.
struct PlotKind {
  std::string_view name;  ///< "curve"
  std::string_view doc;   ///< one line for `--list`
};

/// All pictures: "curve", "residuals", "overview", "parameters", "profile", "bootstrap", "laws".
std::span<const PlotKind> plot_kinds();

/// Which picture, of what, and where to.
struct PlotRequest {
  std::string what = {};  ///< name of a kind; empty: a curve for one specimen, else the overview
  /// Name of the target, for a picture of one specimen; empty: the first.
  std::string specimen = {};
  /// Of a file that compares laws: whose fits are drawn; empty: those of the law that is advised.
  /// The picture "laws" draws all.
  std::string law = {};
  /// A path that ends in .svg, .png, .pdf, or .gp for the script with its data; "-" for a picture
  /// of characters on standard output.
  std::string output = {};
  io::Overwrite overwrite = io::Overwrite::Allowed;
};

/// The picture as a gnuplot script with its data, without terminal and output.
/// @throws InputError for a kind or specimen that does not exist, or one without a curve
std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request);

/// Draws and writes the picture; a file is replaced as a whole or left alone.
/// @param standard_output  where a picture of characters goes
/// @throws InputError as plot_script, and for an output of another kind; MachineError if gnuplot
///         is missing or fails, or the file cannot be written
void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output);

}  // namespace plastica::calibrate
