#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/problem/parameter.hpp"
#include "plastica/io/result_file.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// A scene that a fit went through, as the fit's result stores it.
struct StoredScene {
  std::string name;            ///< of its file, without the folder: "bend_test.toml"
  std::optional<Setup> setup;  ///< with what the target changes in it; empty if it cannot be read
  std::string why_not;  ///< else the error line: a coupon's strains may stand in another file
};

/// What the texts in a result say of its fits through scenes.
struct StoredSceneFit {
  std::vector<StoredScene> scenes;          ///< in the order of the targets, equal ones once
  std::vector<std::size_t> scene_of_table;  ///< of each [[target]], which of the scenes
  std::vector<Parameter> parameters;        ///< free, fixed and tied
};

/// Reads the fit file and the scenes among the inputs of a result of fits through scenes; empty if
/// they are not all there, as in a result that no command wrote.
/// @param inputs  the fit file, then its scenes, each file once and in the order of the targets
/// @throws InputError if the fit file's text is none
std::optional<StoredSceneFit> read_stored_scenes(const std::vector<io::InputText>& inputs);

}  // namespace plastica::calibrate
