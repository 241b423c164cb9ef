#pragma once

#include <string>

#include "plastica/model/section_kind.hpp"

/// What the files of the shapes share; not installed.
namespace plastica::model_detail {

/// W and the outer distances, which follow from I and the half sides.
void set_bending(SectionProperties& p, double half_width, double half_height);

/// "12.5", the length in mm.
std::string in_mm(double length);
/// "100 x 50 mm".
std::string sides_in_mm(double width, double height);

/// Checks that a dimension is above zero and below another one.
void require_inside(double inner, double outer, const SourceLocation& where,
                    std::string_view inner_field, std::string_view outer_field);

/// One shape each, in a file of its own.
const SectionKind& rectangle_kind();
const SectionKind& circle_kind();
const SectionKind& round_tube_kind();
const SectionKind& rectangular_tube_kind();
const SectionKind& i_section_kind();
const SectionKind& numbers_kind();

}  // namespace plastica::model_detail
