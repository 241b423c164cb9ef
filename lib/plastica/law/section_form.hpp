#pragma once

#include <array>
#include <cstddef>

#include "plastica/law/section_response.hpp"
#include "plastica/law/uniaxial_material.hpp"
#include "plastica/model/material.hpp"
#include "plastica/model/section.hpp"

namespace plastica::law {

/// The components of a section's strain and force.
enum Axis : std::size_t { kBendingX, kBendingY, kTorsion, kAxial };

/// Everything about a section law that does not depend on the material's numbers: how the strain
/// and the force of each component stand to those of its extreme fibre.
///
///   strain of the extreme fibre = lever x section strain,  force = modulus x its stress,
/// so that stiffness x lever x modulus is E I, G J, E A.
struct SectionForm {
  std::array<UniaxialForm, kSectionAxes> axis{};
  std::array<double, kSectionAxes> lever{};    ///< I/W, J/W_t [m], and 1
  std::array<double, kSectionAxes> modulus{};  ///< W_x, W_y, W_t [m^3], A [m^2]
};

/// Derives the form of a section's law.
///
/// Cap factors: 1 at first yield, the shape factors Z/W when fully plastic. Wendelius' formulas:
///   bending: k = E I/(2 l) by its (1), half of E I/l; caps sigma I_x/b, sigma I_y/h by its (4) and
///            (5), against sigma I_x/(h/2);
///   torsion: k = G I_A/(2 l) by its (2), I_A = max(I_x, I_y), so I_A/(2 J);
///            cap by its (6) over tau W_t. Circles: caps by its (22), (23), which are right.
/// Stretch is not in Wendelius' report.
SectionForm section_form(const Section& section, const SectionProperties& properties,
                         const Material& material, YieldCap cap, Formulas formulas);

}  // namespace plastica::law
