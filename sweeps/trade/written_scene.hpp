#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plastica/model/field.hpp"

namespace plastica::sweeps {

/// The text of a scene's file with values of fields filled in, and all else as it was written.
/// @param values  fields and what they are to be; an unset one is left as it is
/// @param wanted  the setup that the text must then be read as
/// @param file    its path, in whose folder the tables are that it names
/// @param output  where the new text will stand: it names the same tables from there
/// @throws InputError if a value cannot be written there
std::string scene_with_values(const std::string& text,
                              const std::vector<std::pair<const Field*, FieldValue>>& values,
                              const Setup& wanted, const std::string& file = "scene",
                              const std::string& output = "scene");

/// Refuses a value that no scene's file can have. @throws InputError
[[noreturn]] void refuse_to_write(const Field& field, const FieldValue& value);

}  // namespace plastica::sweeps
