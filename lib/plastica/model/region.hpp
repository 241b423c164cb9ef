#pragma once

#include <string_view>

#include "plastica/model/field.hpp"

namespace plastica {

/// Whether a region says a field of its section or material itself.
bool is_own(const Region& region, std::string_view path);

/// Whether a field of the beam's section or material is that of a region, too.
bool stands_in_regions(const Scene& scene, const Field& field);

/// Gives regions all that is not their own, names included: to be called when the beam's section or
/// material has changed. Of a taper's end, what is not its own is that of its beginning.
void follow_beam(Scene& scene);

/// The section of a taper.
/// @param fraction  of the way from `from` to `to` [1], 0 … 1
Section tapered_section(const Region& region, double fraction);

/// Sets a field, in the regions that follow the beam too.
/// @throws InputError as `set_field`
void set_everywhere(Setup& setup, const Field& field, const FieldValue& value);

}  // namespace plastica
