#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "plastica/io/result_file.hpp"
#include "plastica/io/scene_file.hpp"
#include "plastica/model/field.hpp"
#include "plastica/run/beam_outline.hpp"
#include "plastica/run/response.hpp"

namespace plastica::io {

/// The attributes `schema` and `version` of the root of a simulated scene's file.
inline constexpr std::string_view kSceneSchema = "plastica/scene";
inline constexpr int kSceneVersion = 3;
inline constexpr int kOldestScene = 2;  ///< that is read

/// A scene that was simulated, and what came out.
struct SceneRecord {
  Setup setup;  ///< with places that are fractions of the length; read back whole
  Level level = Level::Coupon;
  std::string level_reason;
  std::vector<std::string> warnings;
  BeamOutline outline;  ///< empty for a coupon
  /// With the samples that are valid and no others.
  Response response;
  std::vector<InputText> inputs;  ///< the scene file
  RunMeta meta;
};

/// Cuts what is behind the last valid sample off a response, all of one that was not begun.
void keep_valid_samples(Response& response);

/// Puts together what is known of a scene and its run; without meta. Places become fractions of
/// the length, and the response ends behind its last valid sample.
/// @param model  of the scene
SceneRecord make_scene_record(const SceneFile& file, const Model& model, Response response);

/// Writes the result file of a scene (HDF5; layout: docs/hdf5.md). The same record gives the
/// same bytes outside /meta. The file appears under its name when it is complete,
/// in place of what is there if that is allowed.
/// @param record  from `make_scene_record`
/// @param write_more  writes groups of other formats beside the result; may be empty
/// @throws StorageError if it cannot be written
void write_scene_store(const std::string& path, const SceneRecord& record,
                       Overwrite overwrite = Overwrite::Allowed,
                       const std::function<void(Hdf5Group& root)>& write_more = {});

/// Reads such a file, every number bit by bit.
/// @throws InputError if it is no such file, of another version, or not complete
SceneRecord read_scene_store(const std::string& path);

}  // namespace plastica::io
