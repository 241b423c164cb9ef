#pragma once

#include "plastica/io/scene_store.hpp"
#include "plastica/report/plot_script.hpp"

/// The picture of a simulated beam; not installed.
namespace plastica::report {

/// The undeformed and the deformed beam at true scale, in its plane or in space, coloured by
/// plastic strain, with supports, loads and earlier samples of a planar path.
PlotScript shape_page(const io::SceneRecord& record);
/// The axis before and after, as characters.
PlotScript shape_terminal(const io::SceneRecord& record);

}  // namespace plastica::report
