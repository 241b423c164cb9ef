#pragma once

#include "plastica/io/toml.hpp"
#include "plastica/model/history.hpp"
#include "plastica/model/place.hpp"

/// Places on the beam and histories over time, as a scene file writes them; not installed.
namespace plastica::io {

/// "start", "end", { segment = 3 } (the outer end of that segment, from 1; 0 is the start), or a
/// fraction of the length: 0.25, 1.0, "25 %". An integer other than 0 could be either and is
/// refused.
Place read_place(const TomlValue& value);

/// "ramp", "constant", or one of
///   { cycles = n }                                  0, then n times over 1 and -1, then 0,
///   { turning_points = [1, -1, 0.5] }               from 0 over these,
///   { time = ["0 s", "2 s"], factor = [0, 1] }      straight between these,
/// where turning points follow each other in whole seconds. A ramp goes on after its end; all
/// others hold their last factor.
History read_history(const TomlValue& value);

}  // namespace plastica::io
