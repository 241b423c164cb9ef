#include "plastica/theory/torsion_elastic.hpp"

namespace plastica::theory {
namespace {

/// kappa alone asks for nu; nothing here uses it.
SectionProperties properties(const Section& section) { return section_properties(section, 0.0); }

}  // namespace

double end_twist(const Section& section, double shear_modulus, double length, double torque) {
  return torque * length / (shear_modulus * properties(section).torsion_constant);
}

double end_twist_distributed(const Section& section, double shear_modulus, double length,
                             double distributed) {
  return end_twist(section, shear_modulus, length, 0.5 * distributed * length);
}

double largest_shear_stress(const Section& section, double torque) {
  return torque / properties(section).torsion_modulus;
}

}  // namespace plastica::theory
