#pragma once

#include <string>

#include "sweeps/check/claim.hpp"

namespace plastica::sweeps {

/// A number of a claim with its unit, as reports show it.
std::string number_text(const CheckFile& file, const Claim& claim, double number);

/// A value of the parameter of a claim on fits, with its unit: "277.8 MPa".
std::string parameter_text(const Claim& claim, double value);

/// What is wanted of it: "at most 0.01 %", "1.98 … 2.02", "to hold 355 MPa".
std::string limit_text(const CheckFile& file, const Claim& claim);

}  // namespace plastica::sweeps
