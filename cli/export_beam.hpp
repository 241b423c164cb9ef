#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/result_kind.hpp"

namespace plastica::cli {

/// What of a beam is asked for.
struct BeamRequest {
  std::string file;    ///< of fits, or a simulated scene, or a scene file
  std::string to;      ///< one of `calibrate::engine_formats()`
  std::string scene;   ///< the beam of a fit: a file, or the name of one that the fit went through
  std::string which;   ///< the specimen of a fit; empty: the only one
  std::string target;  ///< of a fit through scenes; empty: all, if they went through one scene
  std::optional<int> segments;
  std::string up;        ///< the axis that points up; empty: as in the scene
  std::string gravity;   ///< with its unit, as the next one; empty: the scene's
  std::string damping;   ///< the damping time of the joints
  std::string contacts;  ///< what the segments touch; empty: nothing
};

/// What --contacts may be.
std::span<const std::string_view> contact_words();

/// The beam of a result or of a scene file as the text of an engine's format. What the format does
/// not hold of the scene is said on stderr.
/// @param kind  of the file: fits, fits through scenes, or a scene
/// @throws InputError
std::string beam_text(const BeamRequest& request, ResultKind kind);

}  // namespace plastica::cli
