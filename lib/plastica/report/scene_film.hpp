#pragma once

#include <optional>

#include "plastica/io/scene_store.hpp"
#include "plastica/report/plot_script.hpp"

/// Film strips of a simulated beam; not installed.
namespace plastica::report {

/// Which frames a film strip shows.
struct FilmRequest {
  int frames = 8;                ///< >= 1
  std::optional<double> from{};  ///< [s]; empty: the beginning
  std::optional<double> to{};    ///< [s]; empty: the end
};

/// Frames at even times beside and below each other, all at the same scale and from the same place,
/// positions as they are, coloured by plastic strain, with supports and loads; fragments apart.
/// @throws InputError if it ends before it begins
PlotScript film_page(const io::SceneRecord& record, const FilmRequest& request,
                     const Sheet& sheet = {});
/// The axes of the frames, as characters.
PlotScript film_terminal(const io::SceneRecord& record, const FilmRequest& request);

}  // namespace plastica::report
