#pragma once

#include <span>

#include "sweeps/compare/closed_forms.hpp"

/// The closed forms by what they are about; not installed.
namespace plastica::sweeps {

std::span<const ClosedForm> elastic_forms();
std::span<const ClosedForm> yielding_forms();
std::span<const ClosedForm> motion_forms();

}  // namespace plastica::sweeps
