#pragma once

#include <optional>
#include <string>

#include "plastica/model/field.hpp"
#include "plastica/run/response.hpp"

namespace plastica::sweeps::stability {

/// How far an audit lets rounding and Newton's tolerance go, over the largest moment, force or
/// length [1].
inline constexpr double kAuditTolerance = 1e-6;

/// Whether all that a response says up to its last sample is finite.
bool is_finite(const Setup& setup, const Response& response);

/// Checks the last recorded shape of a chain against mechanics, from what the response says alone:
///
/// - rigid segments are as long as they were;
/// - no ideal joint carries more than its section: at most the elastic or the plastic cap, of
/// fibres
///   the plastic moment;
/// - in statics, loads, weight and reactions balance, and each joint carries the moment that those
///   beyond it make about it, in the beam's present shape.
///
/// Beams of other materials or sections along them are audited for their length alone, those whose
/// joints shift for the sum of their forces, and those on a bed of springs for length and caps.
/// @return what is wrong; empty if nothing is
std::optional<std::string> audit(const Setup& setup, const Response& response);

}  // namespace plastica::sweeps::stability
