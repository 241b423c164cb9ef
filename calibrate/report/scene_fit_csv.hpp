#pragma once

#include <iosfwd>
#include <span>

#include "calibrate/result/scene_fit_record.hpp"

namespace plastica::calibrate {

/// Tables of fits through scenes: SI, the units in the header or, where they differ from row to
/// row, in a column of their own; quoted after RFC 4180 with line feeds; what is missing is an
/// empty cell. Numbers have all their digits.

/// Where laws are compared a fit is called by its name and law, "bend:voce", in the tables that
/// have no column of laws.

/// A row per fit: name, law, status, reason and, per parameter, value, standard error, interval,
/// value extrapolated in the segments, half interval that they leave, intervals of profile and
/// bootstrap where any fit has them, and verdict; cost of the best search, runs.
void write_scene_fits_csv(std::ostream& out, std::span<const SceneFitRecord> records);

/// A row per target: what it was measured over, and how well its fit follows it.
void write_scene_targets_csv(std::ostream& out, std::span<const SceneFitRecord> records);

/// A row per sample: fit, target, abscissa, measured and fitted ordinate, the fitted one's standard
/// error.
void write_scene_fit_curves_csv(std::ostream& out, std::span<const SceneFitRecord> records);

}  // namespace plastica::calibrate
