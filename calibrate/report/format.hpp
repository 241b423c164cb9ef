#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "calibrate/result/result.hpp"
#include "calibrate/result/words.hpp"
#include "calibrate/target/target.hpp"
#include "plastica/report/format.hpp"

/// How the fixed words of fits look in everything that people read.
namespace plastica::calibrate::report {

using plastica::report::brief;
using plastica::report::counted;
using plastica::report::cut;
using plastica::report::decimals_for;
using plastica::report::display_unit;
using plastica::report::DisplayUnit;
using plastica::report::printable;
using plastica::report::quantity;
using plastica::report::significant;
using plastica::report::width_of;
using plastica::report::with_error;
using plastica::report::wrapped;

/// Why there is no fit: the result's reason, else the target's; empty for a fitted one.
std::string reason_of(const FitRecord& record);

/// " (2 of no use)" behind the number of fits; empty for none.
std::string unusable_text(std::size_t count);

/// The unit in which a parameter of about this size is shown.
DisplayUnit display_unit_of(std::string_view path, Dimension dimension, double size);

/// The size of a correction in the unit that people use: "+0.021 %".
std::string size_of(const Correction& correction);

/// What a repair did without how often, which stands before it: "rows without strain dropped".
std::string sentence_of(const Repair& repair);

}  // namespace plastica::calibrate::report
