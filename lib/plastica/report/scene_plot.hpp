#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// A picture that the file of a simulated scene can be drawn as.
struct ScenePlotKind {
  std::string_view name;  ///< "shape"
  std::string_view doc;   ///< one line for `--list`
};

/// All pictures: "shape", "moment", "joint", "load", "energy".
std::span<const ScenePlotKind> scene_plot_kinds();
/// Those that a file has: a coupon has but "joint".
std::vector<ScenePlotKind> scene_plot_kinds_of(const io::SceneRecord& record);

/// Which picture, of what, and where to.
struct ScenePlotRequest {
  std::string what = {};          ///< name of a kind; empty: the first that the file has
  std::optional<int> joint = {};  ///< of the picture "joint"; empty: that of the largest strain
  std::string probe = {};         ///< of the picture "load"; empty: the first displacement
  std::string output = {};        ///< as for `draw_picture`
};

/// The picture as a gnuplot script with its data, without terminal and output. "moment", "joint"
/// and "load" lay several records over each other; the others take one.
/// @throws InputError for a picture, joint or probe that the file does not have
std::string scene_plot_script(std::span<const io::SceneRecord> records,
                              const ScenePlotRequest& request);

/// Draws and writes the picture. @throws InputError as above; else as `draw_picture`
void draw_scene_plot(std::span<const io::SceneRecord> records, const ScenePlotRequest& request,
                     std::ostream& standard_output);

}  // namespace plastica::report
