#pragma once

#include <iosfwd>
#include <span>

#include "calibrate/result/result.hpp"

namespace plastica::calibrate {

/// A table with a row per specimen: name, file, status, reason, groups, characteristics and, per
/// parameter, value, standard error and interval, those of profile and bootstrap where any specimen
/// has them. SI, units in the header as "rp02 [Pa]", quoted
/// after RFC 4180 with line feeds; what a specimen does not have is an empty cell. Numbers have
/// all their digits.
void write_specimens_csv(std::ostream& out, std::span<const FitRecord> records);

/// The curves: a row per sample with specimen, strain [1], measured and fitted stress [Pa]. A
/// sample that only one of the two curves has leaves the other's cell empty, so does a specimen
/// without a fit; of a rejected one the samples as read are written.
void write_curves_csv(std::ostream& out, std::span<const FitRecord> records);

}  // namespace plastica::calibrate
