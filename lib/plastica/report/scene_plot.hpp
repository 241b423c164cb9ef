#pragma once

#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/output_file.hpp"
#include "plastica/io/scene_store.hpp"

namespace plastica::report {

/// A picture that the file of a simulated scene can be drawn as.
struct ScenePlotKind {
  std::string_view name;  ///< "shape"
  std::string_view doc;   ///< one line for `--list`
};

/// All pictures: "shape", "film", "moment", "joint", "load", "history", "energy", "spectrum".
std::span<const ScenePlotKind> scene_plot_kinds();
/// Those that a file has, the one that belongs to it first: a motion has "film", a path "shape", a
/// coupon but "joint".
std::vector<ScenePlotKind> scene_plot_kinds_of(const io::SceneRecord& record);

/// Which picture, of what, and where to.
struct ScenePlotRequest {
  std::string what = {};  ///< name of a kind; empty: the first that the file has
  std::optional<int> joint =
      {};  ///< of "joint"; empty: that which broke, else of the largest strain
  /// Of the pictures "load", "history" and "spectrum"; empty: the first displacement.
  std::string probe = {};
  std::string output = {};  ///< as for `draw_picture`
  io::Overwrite overwrite = io::Overwrite::Allowed;
  std::optional<double> width = {};      ///< as for `sheet_of` [mm]
  std::optional<double> time = {};       ///< of "shape" and "moment" [s]; empty: the last frame
  std::optional<int> film_frames = {};   ///< of "film", >= 1; empty: 8
  std::optional<double> film_from = {};  ///< of "film" [s]; empty: the beginning
  std::optional<double> film_to = {};    ///< of "film" [s]; empty: the end
};

/// The picture as a gnuplot script with its data, without terminal and output. "shape", "film" and
/// "energy" take one record; the others lay several over each other.
/// @throws InputError for a picture, joint or probe that the file does not have
std::string scene_plot_script(std::span<const io::SceneRecord> records,
                              const ScenePlotRequest& request);

/// Draws and writes the picture. @throws InputError as above; else as `draw_picture`
void draw_scene_plot(std::span<const io::SceneRecord> records, const ScenePlotRequest& request,
                     std::ostream& standard_output);

}  // namespace plastica::report
