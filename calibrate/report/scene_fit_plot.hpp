#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "calibrate/report/plot.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// All pictures of fits through scenes: "fit", "residuals", "starts", "correlation", "segments",
/// "profile", "bootstrap", "population".
std::span<const PlotKind> scene_fit_plot_kinds();

/// The picture as a gnuplot script with its data, without terminal and output.
/// @param request  its specimen is the name of a fit; empty: the first
/// @throws InputError for a kind or fit that does not exist, or one without what is to be drawn
std::string scene_fit_plot_script(std::span<const SceneFitRecord> records,
                                  const PlotRequest& request);

/// Draws and writes the picture; a file is replaced as a whole or left alone.
/// @param standard_output  where a picture of characters goes
/// @throws InputError as scene_fit_plot_script, and for an output of another kind; MachineError if
///         gnuplot is missing or fails, or the file cannot be written
void draw_scene_fit_plot(std::span<const SceneFitRecord> records, const PlotRequest& request,
                         std::ostream& standard_output);

}  // namespace plastica::calibrate
