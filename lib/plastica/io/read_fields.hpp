#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "plastica/io/toml.hpp"
#include "plastica/model/field.hpp"

/// Parts that the readers of TOML files share; not installed.
namespace plastica::io {

/// Sets a field from the value at a dotted path, if the table has one. Errors name the key as the
/// file has it.
void read_field(const TomlTable& table, std::string_view path, const Field& field, Setup& setup);

/// Sets every field whose path begins with `prefix` ("section.") from the table of its keys; what
/// the table does not say stays as it is.
void read_part(const TomlTable& table, std::string_view prefix, Setup& setup);

/// Reads a material: the name of one, or a table of fields with a `name` as their base.
void read_material(const TomlValue& value, Setup& setup);

/// Refuses a section that lacks a dimension of its shape. @throws InputError
void refuse_missing_dimensions(const TomlValue& section, const Section& read);

/// Reads a section: the name of a profile, or a table of fields, or of a `profile` alone.
/// @throws InputError if a shape that has no defaults lacks a dimension
void read_section(const TomlValue& value, Setup& setup);

/// The paths of what a value says of a section or a material: all of it, "material", where it has a
/// name. @param part  "section" or "material"
std::vector<std::string> paths_said(const TomlValue& value, const std::string& part);

/// What the beam is made of, [section] or [material]: of the file, or as a key of [beam].
/// @throws InputError if both are there
std::optional<TomlValue> part_of_beam(const TomlTable& root, std::string_view name);

/// A list of x, y and z.
std::array<double, 3> read_vector(const TomlValue& list, Dimension dimension);

/// A unit vector: "x", "-y", or a list of three numbers along it.
std::array<double, 3> read_direction(const TomlValue& value);

/// A list of quantities that is not empty.
std::vector<double> read_quantities(const TomlValue& list, Dimension dimension);

/// Where a file says what an error names, "support[2].at": the line of the key, or of the nearest
/// table around it that is there.
SourceLocation locate(const TomlTable& root, std::string_view field);

}  // namespace plastica::io
