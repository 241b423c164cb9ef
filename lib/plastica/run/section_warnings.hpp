#pragma once

#include <optional>
#include <string>

#include "plastica/run/warning_facts.hpp"

/// What a section that is one joint leaves out of what its fibres do; not installed.
namespace plastica::run_detail {

/// A fully plastic cap scales the stress of the outermost fibre by Z/W times the elastic lever, its
/// slope of hardening, too; once all fibres flow the section has E_t I.
std::optional<std::string> steep_hardening_warning(const Facts& facts);

/// A fully plastic cap takes the rate of the outermost fibre for all of the section. Fibres at a
/// distance y flow at a rate in proportion to y, so that with r of the outermost, of Cowper and
/// Symonds, a rectangle in bending adds
///   int_0^1 2 y (y r/C)^(1/P) dy = (r/C)^(1/P) 2P/(2P + 1),
/// and of Johnson and Cook int_0^1 2 y c ln(y r/r_0) dy = c (ln(r/r_0) - 1/2).
std::optional<std::string> whole_section_rate_warning(const Facts& facts);

/// The strain that is held against a break limit is of what stays of a joint's rotation without its
/// moment: (h/2) (kappa - M/EI). The extreme fibre has (h/2) kappa - sigma/E there, more by up to
/// (Z/W - 1) sigma_y/E.
std::optional<std::string> break_measure_warning(const Facts& facts);

}  // namespace plastica::run_detail
