#pragma once

#include <iosfwd>
#include <span>

#include "calibrate/result/result.hpp"
#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// Tables of fits: SI, units in the header as "proof_stress [Pa]" or, where they differ from row to
/// row, in a column of their own; quoted after RFC 4180 with line feeds; what a fit does not have
/// is an empty cell. Numbers have all their digits. Where laws are compared a fit is called by its
/// name and law, "bend:voce", in the tables that have no column of laws.

/// A row per fit: what JSON has of it but for lists; of curves characteristics and groups; per
/// parameter value, errors, interval, bounds and verdict, of fits through scenes the value
/// extrapolated in the segments and half the interval that they leave, and the intervals of profile
/// and bootstrap where any fit has them.
void write_fits_csv(std::ostream& out, std::span<const FitRecord> records);
void write_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records);

/// A row per target: what it was measured over, and how well its fit follows it.
void write_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records);

/// The curves: a row per sample with specimen, strain [1], measured and fitted stress [Pa]. A
/// sample that only one of the two curves has leaves the other's cell empty, so does a specimen
/// without a fit; of a rejected one the samples as read are written.
void write_curves_csv(std::ostream& out, std::span<const FitRecord> records);
/// A row per sample: fit, target, abscissa, measured and fitted ordinate, the fitted one's standard
/// error.
void write_curves_csv(std::ostream& out, std::span<const SceneFitRecord> records);

}  // namespace plastica::calibrate
