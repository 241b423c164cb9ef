#pragma once

#include <string>
#include <string_view>

#include "plastica/base/check.hpp"
#include "plastica/base/quantity.hpp"

namespace plastica::io {

/// A linear conversion to SI: si = scale * value + offset.
struct UnitConversion {
  double scale = 1.0;
  double offset = 0.0;
  double operator()(double value) const { return scale * value + offset; }
};

/// The conversion of a unit to the library's SI unit of a dimension.
///
/// Knows what udunits2 knows ("MPa", "ksi", "N/mm^2", "degC", "mm^2") and, for strains, "%", "1",
/// "mm/mm", "in/in", "m/m", "um/m", "microstrain"; for angles "rad", "deg", "°". An empty unit is
/// the same as "1": right for strains and pure numbers, an error for all else. Safe to call from
/// several threads.
/// @throws InputError whose rule says what kind of unit is wanted; `where` and `field` go into it
UnitConversion unit_conversion(std::string_view unit, Dimension dimension,
                               const SourceLocation& where = {}, std::string_view field = {});

/// Whether `unit_conversion` knows a unit for a dimension.
bool is_unit_of(std::string_view unit, Dimension dimension);

/// Whether a text is a unit, of whatever dimension, also of one that we do not have ("V"). A
/// column's header "Stress (MPa)" has one, "Stress (true)" has not. A number alone is none: "Run
/// (2)".
bool is_unit(std::string_view text);

/// Whether a text is a power of ten and a unit: "10 MPa", "x10 N". `unit_conversion` refuses it.
bool is_scaled_unit(std::string_view text);

/// The factor in a column's name that scales its numbers, where these are of a dimension: "10 N" of
/// "Force (10 N)", "x10" of "Stress (x10)", "10^-3" of "Strain (10^-3)". Empty if it holds none:
/// "Stress (20 degC)", "Strain (50 mm)", "Run (10)" say what the numbers are of.
/// @param has_unit  whether the column has one beside its name: then "Load cell 10 kN" is what was
///                  measured with
std::string factor_in_name(std::string_view name, Dimension dimension, bool has_unit = false);

/// Reads "355 MPa", "0.2 %", "1e-3" into SI. A strain of 1 and more needs its unit: "20" may be
/// meant in percent.
/// @throws InputError if there is no number, or the unit does not fit
double parse_quantity(std::string_view text, Dimension dimension, const SourceLocation& where = {},
                      std::string_view field = {});

}  // namespace plastica::io
