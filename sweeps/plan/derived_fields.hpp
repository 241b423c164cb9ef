#pragma once

#include <span>
#include <string_view>

#include "plastica/model/field.hpp"

namespace plastica::sweeps {

/// What an axis may move besides the fields of scene and solver: what is made of several of them,
/// or of loads and motions, which have no field. Each is set once, on the scene as its file has it.
std::span<const Field> derived_fields();

/// Whether one of two fields is derived and sets the other, so that one of both has no effect.
bool set_one_number(const Field& a, const Field& b);

/// The field or derived field of a path, or of the last part of a path where that is unique.
/// @throws InputError that says where all are listed
const Field& find_axis_field(std::string_view name, const SourceLocation& where = {});

}  // namespace plastica::sweeps
