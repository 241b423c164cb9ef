#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/output_file.hpp"
#include "sweeps/store/sweep_record.hpp"

namespace plastica::sweeps {

/// A picture that the file of a sweep can be drawn as.
struct SweepPlotKind {
  std::string_view name;  ///< "convergence"
  std::string_view doc;   ///< one line for `--list`
};

/// All pictures: "convergence", "value", "trade", "curve", "map".
std::span<const SweepPlotKind> sweep_plot_kinds();
/// Those that a sweep has, the one that belongs to it first.
std::vector<SweepPlotKind> sweep_plot_kinds_of(const SweepRecord& record);

/// Which picture, of which cases, and where to.
struct SweepPlotRequest {
  std::string what = {};    ///< name of a kind; empty: the first that the sweep has
  std::string cases = {};   ///< as for `select_cases`; empty: all
  std::string output = {};  ///< as for `report::draw_picture`
  io::Overwrite overwrite = io::Overwrite::Allowed;
  std::optional<double> width = {};  ///< as for `report::sheet_of` [mm]
};

/// The picture as a gnuplot script with its data, without terminal and output.
/// @throws InputError for a picture that the sweep does not have, and for cases that are too many
std::string sweep_plot_script(const SweepRecord& record, const SweepPlotRequest& request);

/// Draws and writes the picture. @throws InputError as above; else as `report::draw_picture`
void draw_sweep_plot(const SweepRecord& record, const SweepPlotRequest& request,
                     std::ostream& standard_output);

}  // namespace plastica::sweeps
