#pragma once

#include <optional>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/plot_script.hpp"

/// The picture of a simulated beam; not installed.
namespace plastica::report {

/// The undeformed beam and the one at a time at true scale, in its plane or in space, coloured by
/// plastic strain, with supports, loads and earlier frames of a planar path; fragments apart.
/// @param time  the frame next to it is drawn; empty: the last one
PlotScript shape_page(const io::SceneRecord& record, std::optional<double> time,
                      const Sheet& sheet = {});
/// The axis before and then, as characters.
PlotScript shape_terminal(const io::SceneRecord& record, std::optional<double> time);

}  // namespace plastica::report
