#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

/// Warnings of joints: how long those are that can break, and those that nobody sees; not
/// installed.
namespace plastica::run_detail {

/// Joints longer than the hinge length make a break depend on the segments.
std::optional<std::string> hinge_warning(const Facts& facts);

/// A held rotation within the beam: half joints to the ground on both sides, where no node's joint
/// is.
std::optional<std::string> inner_clamp_warning(const Facts& facts);

/// Two supports that hold the beam in bending with one segment between them: it is rigid, and what
/// they carry is that of a beam which does not bend there.
std::optional<std::string> rigid_stretch_warning(const Facts& facts);

}  // namespace plastica::run_detail
