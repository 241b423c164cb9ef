#pragma once

#include <vector>

#include "plastica/io/toml.hpp"
#include "sweeps/plan/sweep.hpp"

/// Parts of the sweep file's reader; not installed.
namespace plastica::sweeps {

/// Reads [[axis]] and [sample] and adds them to the sweep's axes, which are those of [set] so far.
void read_axes(const io::TomlTable& root, Sweep& sweep);

/// A value of a field as a file has it: "32", "1 ms", "half_joint", "unset" for an optional field.
/// @throws InputError if it is out of the field's range
FieldValue read_field_value(const io::TomlValue& value, const Field& field, const Setup& base);

/// Reads [error] into the sweep: quantity, reference, scale, refined axis.
void read_error(const io::TomlTable& root, Sweep& sweep);
/// The same from the table that has these keys.
void read_compared(const io::TomlTable& table, Sweep& sweep);

/// Sets fields of a setup, whatever their order: first a named material, then fields, then what is
/// derived of them, the number of segments by their depth last.
void apply(Setup& setup, const std::vector<const Field*>& fields,
           const std::vector<FieldValue>& values);

}  // namespace plastica::sweeps
