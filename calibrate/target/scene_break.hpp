#pragma once

#include <cstddef>
#include <optional>

#include "calibrate/target/options.hpp"
#include "calibrate/target/scene_target.hpp"

namespace plastica::calibrate {

/// How many samples of a beam's curve came before its break; the rest is cut.
///
/// Automatic: the ordinate falls in one step, and stays, at or below `kBreakZero` of the largest
/// one until the end, by `kBreakDrop` of the largest or more, in a step that does not let the beam
/// go: not towards the abscissa 0 (by more than the tolerance), nor against the ordinate. Over the
/// time of a motion, which has no way back, by half of the largest, to zeros or to three samples or
/// more. Set: broken beyond the amount, an abscissa in SI.
/// @param tolerance  how far the abscissa may run back as noise [SI]
/// @return empty: it did not break
std::optional<std::size_t> intact_samples(const SceneTarget& target, const CorrectionChoice& trim,
                                          double tolerance = 0.0);

/// Cuts a curve at its break, which lies anywhere between the last intact sample and the next, or a
/// step on where that stands still (`end_of_break`); of an abscissa that is not driven, from the
/// largest that was intact on.
void cut_at_break(SceneTarget& target, const CorrectionChoice& trim, double tolerance);

}  // namespace plastica::calibrate
