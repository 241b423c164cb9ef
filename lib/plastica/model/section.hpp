#pragma once

#include <memory>
#include <optional>
#include <string>

#include "plastica/base/check.hpp"

namespace plastica {

/// The cross sections that a beam can have.
enum class SectionShape {
  Rectangle,        ///< width x height
  Circle,           ///< radius
  RoundTube,        ///< radius, inner_radius
  RectangularTube,  ///< width x height around a centred hole, inner_width x inner_height
  ISection,         ///< width, height, flange_thickness, web_thickness, fillet_radius
  Numbers,          ///< `numbers`, of any shape that is symmetric about both axes
};

/// A section that is given by its numbers, all of which it needs: as in `SectionProperties`.
struct SectionNumbers {
  double area = 0.0;                       ///< A [m^2]
  double second_moment_x = 0.0;            ///< I_x [m^4]
  double second_moment_y = 0.0;            ///< I_y [m^4]
  double section_modulus_x = 0.0;          ///< W_x [m^3]
  double section_modulus_y = 0.0;          ///< W_y [m^3]
  double plastic_section_modulus_x = 0.0;  ///< Z_x [m^3], >= W_x
  double plastic_section_modulus_y = 0.0;  ///< Z_y [m^3], >= W_y
  double torsion_constant = 0.0;           ///< J [m^4]
  double torsion_modulus = 0.0;            ///< W_t [m^3]
  double plastic_torsion_modulus = 0.0;    ///< [m^3], >= W_t
};

/// A cross section. z runs along the beam, the width along x, the height along y; a field that the
/// shape does not have is ignored. The defaults are valid together for rectangle, circle and tubes;
/// the other shapes have none.
struct Section {
  SectionShape shape = SectionShape::Rectangle;
  double width = 0.1;             ///< b, along x [m], > 0: rectangle, rectangular tube
  double height = 0.1;            ///< h, along y [m], > 0: rectangle, rectangular tube
  double radius = 0.05;           ///< R, outer [m], > 0: circle, round tube
  double inner_radius = 0.04;     ///< r [m], 0 < r < radius: round tube
  double inner_width = 0.08;      ///< b_i [m], 0 < b_i < width: rectangular tube
  double inner_height = 0.08;     ///< h_i [m], 0 < h_i < height: rectangular tube
  double flange_thickness = 0.0;  ///< t_f [m], > 0: I-section
  double web_thickness = 0.0;     ///< t_w [m], > 0: I-section, whose web is along y
  double fillet_radius = 0.0;     ///< r [m], >= 0, between flanges and web: I-section
  SectionNumbers numbers{};       ///< numbers
  /// kappa [1], > 0, both directions; empty: Cowper's value for the shape, and of a section given
  /// by its numbers none, so that it cannot shear
  std::optional<double> shear_coefficient{};
  std::string name{};  ///< of a profile, "IPE 200"; what it is calculated with are its dimensions
};

struct SolvedBox;

/// What mechanics needs of a cross section. "x" in a name means: bending about x.
struct SectionProperties {
  double area = 0.0;                       ///< A [m^2]
  double second_moment_x = 0.0;            ///< I_x [m^4]
  double second_moment_y = 0.0;            ///< I_y [m^4]
  double outer_distance_x = 0.0;           ///< largest |y|, the lever arm of bending about x [m]
  double outer_distance_y = 0.0;           ///< largest |x|, the lever arm of bending about y [m]
  double section_modulus_x = 0.0;          ///< W_x = I_x / largest |y| [m^3]: first yield
  double section_modulus_y = 0.0;          ///< W_y = I_y / largest |x| [m^3]
  double plastic_section_modulus_x = 0.0;  ///< Z_x [m^3]: fully plastic moment = sigma_y Z_x
  double plastic_section_modulus_y = 0.0;  ///< Z_y [m^3]
  double torsion_constant = 0.0;           ///< J [m^4]: torque = G J x twist per length
  double torsion_modulus = 0.0;            ///< W_t = T/tau_max [m^3]: first yield
  double plastic_torsion_modulus = 0.0;    ///< T_p/tau_y [m^3]: fully plastic torque
  double shear_coefficient_x = 0.0;        ///< kappa [1] of a shear force along x
  double shear_coefficient_y = 0.0;        ///< kappa [1] of a shear force along y
  /// Bredt's thin-wall values of J [m^4] and W_t [m^3], for comparison: tubes only.
  std::optional<double> bredt_torsion_constant{};
  std::optional<double> bredt_torsion_modulus{};
  std::shared_ptr<const SolvedBox> box{};  ///< of a rectangular tube: how shear is spread over it
};

/// Computes the properties of a cross section.
///
/// - Rectangle: Saint-Venant series, to rounding. Fully plastic torque by Nadai's sand heap.
/// - Rectangular tube: Prandtl's stress function by finite elements, within 0.01 %; takes some
///   10 ms, but for a box that has been solved before. The stress at the sharp re-entrant corners
///   of the hole is infinite in elasticity, whatever the torque; tau_max of the torsion modulus is
///   therefore the largest at the middles of the outer sides. It tends to the solid rectangle's and
///   to Bredt's value in their limits. Real corners are rounded and yield there first without
///   consequence for the torque.
/// - kappa after Cowper (J. Appl. Mech. 33, 1966, 335): rectangle 10(1+nu)/(12+11nu), circle
///   6(1+nu)/(7+6nu), round tube exact, rectangular tube by his thin-wall formula on the middle
///   lines (too low for thick walls: give `shear_coefficient` there), I-section along the web by
///   his thin-wall formula, along the flanges their two rectangles'.
/// - I-section: A, I, W and Z exact with the fillets. J of thin walls with the circles that fit
/// into
///   the junctions (El Darwish & Johnston, J. Struct. Div. ASCE 91, 1965, 203, as European tables
///   have it); W_t = J over the thicker wall; the fully plastic torque by the sand heap. Warping is
///   not modelled: torsion is Saint-Venant's alone.
///
/// @param section        a section that check_section accepts
/// @param poisson_ratio  nu [1], enters kappa only
SectionProperties section_properties(const Section& section, double poisson_ratio);

/// Checks that the dimensions of the section's shape are positive, finite and nested.
/// @throws InputError that names the field: "section.inner_radius = 0.06: must be below …"
void check_section(const Section& section, const SourceLocation& where = {});

}  // namespace plastica
