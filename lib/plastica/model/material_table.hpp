#pragma once

#include <span>
#include <string>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/model/material.hpp"

namespace plastica {

/// A material that a file can name, and where its figures come from.
struct NamedMaterial {
  Material material{};        ///< its `name` is the one to look up
  std::string description{};  ///< what it is, and what its yield stress stands for
  std::string source{};       ///< standard or handbook of every figure
};

/// All named materials: steels, aluminium alloys, one wood.
///
/// Standards give minima of the yield stress, handbooks typical values; `description` says which.
/// None has a break strain: the elongation after fracture that standards list is an average over a
/// gauge length with the neck in it, not the local permanent strain at which a section parts, so
/// it would be wrong by a factor. Fit it, or set `break_strain` yourself.
std::span<const NamedMaterial> material_table();

/// Looks a material up by its exact name.
/// @param name   as in the table: "S355"
/// @param where, field  where the name was read; they go into the message
/// @throws InputError that lists all names
const NamedMaterial& named_material(std::string_view name, const SourceLocation& where = {},
                                    std::string_view field = "material.name");

}  // namespace plastica
