#pragma once

#include <string_view>
#include <vector>

#include "calibrate/problem/parameter.hpp"
#include "plastica/io/toml.hpp"
#include "plastica/model/drive.hpp"

namespace plastica::calibrate {

/// What a fit may move: fields of the material, or, through a scene, any number of the field table.
enum class ParameterScope { Material, Scene };

/// Reads the table `parameters` of [fit]; the default ones where it names none.
/// @throws InputError naming file, line, key, value and rule
std::vector<Parameter> read_parameters(const io::TomlTable& fit,
                                       ParameterScope scope = ParameterScope::Material);

/// The parameters of a fit that names none: youngs_modulus, yield_stress, break_strain, all free.
std::vector<Parameter> default_parameters();

/// The field of a parameter's name: a path, or of a material field its last part.
/// @param key  what to call it in the error
/// @throws InputError with the nearest name there is
const Field& parameter_field(std::string_view name, const SourceLocation& where,
                             std::string_view key, ParameterScope scope = ParameterScope::Material);

/// Whether [material] gives a field of the material, by itself or with the name of a material.
/// @param name  last part of its path
bool material_gives(const io::TomlTable& root, std::string_view name);

/// Refuses a fit of some test that leaves a stiffness or a yield stress neither to the fit nor to
/// the file: a default of the library is no property of the user's material.
/// @param root  the file, whose [material] may give it
/// @throws InputError that names the parameter
void check_material_is_given(const io::TomlTable& root, const std::vector<Parameter>& parameters,
                             Deformation test);

}  // namespace plastica::calibrate
