#pragma once

#include "plastica/model/field_table.hpp"
#include "plastica/model/hardening_kind.hpp"

/// What the files of the hardening laws share; not installed.
namespace plastica::model_detail {

inline constexpr Field kKinematicShare =
    number<PLASTICA_REACH(scene.material.hardening.kinematic_share)>(
        "material.hardening.kinematic_share", Dimension::None, Range{0.0, 1.0},
        "linear, multilinear: share of the hardening that is kinematic",
        MaterialField::KinematicShare);

/// One law each, in a file of its own.
const HardeningKind& ideal_kind();
const HardeningKind& linear_kind();
const HardeningKind& voce_chaboche_kind();
const HardeningKind& multilinear_kind();

}  // namespace plastica::model_detail
