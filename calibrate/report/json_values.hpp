#pragma once

#include "plastica/report/json_values.hpp"

/// What JSON summaries are made of, by their names here; not installed.
namespace plastica::calibrate::report {

using plastica::report::Json;
using plastica::report::number;
using plastica::report::numbers;
using plastica::report::text_or_null;

}  // namespace plastica::calibrate::report
