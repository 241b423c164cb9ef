#pragma once

#include <optional>

#include "calibrate/target/scene_target.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/model/field.hpp"

namespace plastica::calibrate {

/// What the abscissa of a target is: a length, an angle, a force …
/// @throws InputError for a support, load or probe that the scene does not have, or that has no
///         one direction to follow a number in
Dimension abscissa_dimension(const Scene& scene, const SceneTarget& target,
                             const SourceLocation& where = {});

/// What the ordinate of a target is: the quantity of its probe.
/// @throws InputError for a probe that the scene does not have
Dimension ordinate_dimension(const Scene& scene, const SceneTarget& target);

/// The setup that follows a target's measured abscissa: sample i is reached at time i + 1, the
/// first broken one, if there is one, a second after the last; recorded are these.
///
/// A support or load keeps its direction, and its size counts as one: the history's factor is
/// measured/(factor x size). All else that acts must be there from the first (history constant).
/// @throws InputError where the scene cannot follow
Setup driven_setup(const Setup& setup, const SceneTarget& target);

/// The setup whose path goes on to so many times its end: ramps go on along their lines, all other
/// histories hold what they end with. Samples are where they were, and as far apart beyond.
/// @param times  > 1
/// @return none if nothing would go on: in dynamics, where displacement or arc length leads, with
///         no ramp, or with a gravity that grows, which no test goes beyond
std::optional<Setup> extended_setup(const Setup& setup, int times);

}  // namespace plastica::calibrate
