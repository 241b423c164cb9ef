#pragma once

/// Equations of the source document, to the letter, so that its results can be reproduced and its
/// differences from mechanics shown as numbers.
///
/// Source: L. Wendelius, Plasticity and Breaking in lumped modelled beams; the number of each
/// equation is given. b is the width along x, h the height along y; lengths [m], stresses [Pa].
/// What is wrong with an equation is said where it is; the library's own formulas are in
/// plastica/model/section.hpp.
namespace plastica::theory::report {

/// (1): bending stiffness of a joint [N m/rad], Y I/(L_a + L_b). With whole segment lengths, half
/// of E I/l for the tributary length l = (L_a + L_b)/2.
double bending_stiffness(double youngs_modulus, double second_moment, double length_a,
                         double length_b);

/// (2): torsion stiffness of a joint [N m/rad], Y I_A/(2 (L_a + L_b)(1 + nu)). I_A stands where J
/// belongs: torsion_second_moment.
double torsion_stiffness(double youngs_modulus, double poisson_ratio, double second_moment,
                         double length_a, double length_b);

/// I_A of (2): the larger of I_x and I_y [m^4]. J of a circle is twice as large, of a flat
/// rectangle smaller.
double torsion_second_moment(double second_moment_x, double second_moment_y);

/// (4): largest bending moment about x [N m], sigma I_x/b. The lever arm is h/2.
double bending_cap_x(double yield_stress, double second_moment_x, double width);

/// (5): largest bending moment about y [N m], sigma I_y/h. The lever arm is b/2.
double bending_cap_y(double yield_stress, double second_moment_y, double height);

/// (6): largest torque of a rectangle [N m], tau b^2 h^2/(3c + 1.8s), c the longer side; the fit
/// 1/(3 + 1.8 s/c) for Saint-Venant's alpha.
double torsion_cap(double shear_yield_stress, double width, double height);

/// (7), left: permanent strain of bending about x [1], sqrt(2 (b/2)^2 (1 - cos theta))/l. The side
/// across that axis is h: contradicts (24).
double bending_strain_x(double width, double angle, double length);

/// (7), right: permanent strain of bending about y [1], sqrt(2 (h/2)^2 (1 - cos theta))/l.
double bending_strain_y(double height, double angle, double length);

/// (8): permanent shear strain of torsion [1], (c/2) theta/l, c the longer side or the diameter.
/// Right for a circle only; else J/W_t belongs where c/2 stands.
double torsion_strain(double longer_side, double angle, double length);

/// (24): permanent strain of bending [1], sqrt(2 (h/2)^2 (1 - cos theta))/l = (h/l)|sin(theta/2)|.
/// Falls again beyond theta = pi, as printed.
double bending_strain(double height, double angle, double length);

}  // namespace plastica::theory::report
