#pragma once

#include "plastica/model/field_table.hpp"

/// Dimensions that several shapes have.
namespace plastica::model_detail {

inline constexpr Field kSectionWidth = number<PLASTICA_REACH(scene.section.width)>(
    "section.width", Dimension::Length, kPositive, "b, along x");
inline constexpr Field kSectionHeight = number<PLASTICA_REACH(scene.section.height)>(
    "section.height", Dimension::Length, kPositive, "h, along y");
inline constexpr Field kSectionRadius = number<PLASTICA_REACH(scene.section.radius)>(
    "section.radius", Dimension::Length, kPositive, "outer radius R of circle and round tube");

}  // namespace plastica::model_detail
