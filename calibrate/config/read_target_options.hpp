#pragma once

#include "calibrate/target/options.hpp"
#include "plastica/io/toml.hpp"

/// What a [[target]] says of corrections and characteristics; not installed.
namespace plastica::calibrate {

/// Whether a value is a number, or a text that begins as one.
bool is_quantity(const io::TomlValue& value);

/// "auto", "off" or an amount. @param dimension  of the amount
CorrectionChoice read_choice(const io::TomlValue& value, Dimension dimension = Dimension::Strain);

/// [target.corrections]. @throws InputError
void read_corrections(const io::TomlTable& table, TargetOptions& options);

/// [target.characteristics]. @throws InputError
void read_characteristics(const io::TomlTable& table, TargetOptions& options);

}  // namespace plastica::calibrate
