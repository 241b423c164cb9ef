#pragma once

#include "plastica/model/field_table.hpp"
#include "plastica/model/hardening_kind.hpp"

/// What the files of the hardening laws share; not installed.
namespace plastica::model_detail {

inline constexpr Field kKinematicFraction =
    number<PLASTICA_REACH(scene.material.hardening.kinematic_fraction)>(
        "material.hardening.kinematic_fraction", Dimension::None, Range{0.0, 1.0},
        "linear, multilinear: fraction of the hardening that is kinematic",
        MaterialField::KinematicFraction);

/// One law each, in a file of its own.
const HardeningKind& ideal_kind();
const HardeningKind& linear_kind();
const HardeningKind& voce_chaboche_kind();
const HardeningKind& multilinear_kind();

}  // namespace plastica::model_detail
