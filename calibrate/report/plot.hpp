#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"
#include "plastica/io/output_file.hpp"

namespace plastica::calibrate {

/// A picture that a file of fits can be drawn as.
struct PlotKind {
  std::string_view name;  ///< "curve"
  std::string_view doc;   ///< one line for `--list`
};

/// All pictures of fits of curves: "curve", "residuals", "quantiles", "overview", "parameters",
/// "profile", "bootstrap", "laws".
std::span<const PlotKind> plot_kinds();
/// All pictures of fits through scenes: "fit", "residuals", "quantiles", "starts", "correlation",
/// "segments", "profile", "bootstrap", "laws", "population".
std::span<const PlotKind> scene_fit_plot_kinds();

/// Which picture, of what, and where to.
struct PlotRequest {
  /// Name of a kind; empty: of curves one specimen's or the overview, through scenes the fit.
  std::string what = {};
  /// Name of the target or fit, for a picture of one; empty: the first.
  std::string specimen = {};
  /// Of a file that compares laws: whose fits are drawn; empty: those of the law that is advised.
  /// The picture "laws" draws all.
  std::string law = {};
  /// A path that ends in .svg, .png, .pdf, or .gp for the script with its data; "-" for a picture
  /// of characters on standard output.
  std::string output = {};
  io::Overwrite overwrite = io::Overwrite::Allowed;
  std::optional<double> width = {};  ///< as for `plastica::report::sheet_of` [mm]
};

/// The picture as a gnuplot script with its data, without terminal and output.
/// @throws InputError for a kind or specimen that does not exist, or one without what is to be
/// drawn
std::string plot_script(std::span<const FitRecord> records, const PlotRequest& request);
std::string plot_script(std::span<const SceneFitRecord> records, const PlotRequest& request);

/// Draws and writes the picture; a file is replaced as a whole or left alone.
/// @param standard_output  where a picture of characters goes
/// @throws InputError as plot_script, and for an output of another kind; MachineError if gnuplot
///         is missing or fails, or the file cannot be written
void draw_plot(std::span<const FitRecord> records, const PlotRequest& request,
               std::ostream& standard_output);
void draw_plot(std::span<const SceneFitRecord> records, const PlotRequest& request,
               std::ostream& standard_output);

}  // namespace plastica::calibrate
