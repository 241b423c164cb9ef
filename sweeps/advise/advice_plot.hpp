#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "plastica/io/output_file.hpp"
#include "sweeps/advise/advice.hpp"

namespace plastica::sweeps {

/// Error over cost of every setting that was run, the Pareto front, the advised one, that of the
/// scene's file, and a line at the error that is allowed; as a gnuplot script with its data.
/// @param name  of the scene's file
/// @throws InputError if no setting has an error
std::string advice_plot_script(const Advice& advice, const AdviceOptions& options,
                               const std::string& name);

/// Draws and writes that picture.
/// @param output  as for `report::draw_picture`
/// @param width   as for `report::sheet_of` [mm]
/// @throws InputError as above; else as `report::draw_picture`
void draw_advice(const Advice& advice, const AdviceOptions& options, const std::string& name,
                 const std::string& output, std::ostream& standard_output,
                 io::Overwrite overwrite = io::Overwrite::Allowed,
                 std::optional<double> width = {});

}  // namespace plastica::sweeps
