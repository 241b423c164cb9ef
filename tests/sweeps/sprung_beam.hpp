#pragma once

#include <string>

#include "plastica/io/scene_file.hpp"
#include "plastica/model/section.hpp"

namespace plastica::sweeps {

/// A stocky tube on a pin and a roller that a spring at a quarter pushes down: joints that shear at
/// an elastic support have errors of first and second order in the segments, which cancel near ten.
/// Its probe is the spring's reaction.
inline Setup sprung_beam(int segments) {
  return io::parse_scene_file(
             "material = 'S355'\n[beam]\nlength = '0.3 m'\nsegments = " + std::to_string(segments) +
                 "\nsection = { shape = 'rectangular_tube', width = '60 mm', height = '40 mm', "
                 "inner_width = '56 mm', inner_height = '36 mm', shear_coefficient = 0.3 }\n"
                 "[rules]\nyield_model = 'elastic'\n"
                 "[solver]\nsteps = 1\ntranslation = 'elastic'\n"
                 "[[support]]\nat = 'start'\nkind = 'pin'\n"
                 "[[support]]\nat = 'end'\nkind = 'roller'\n"
                 "[[support]]\nat = 0.25\nkind = 'elastic'\n"
                 "stiffness = ['0 N/m', '1e9 N/m', '0 N/m']\n"
                 "translation = ['0 mm', '-0.01 mm', '0 mm']\n"
                 "[[probe]]\nname = 'spring'\nkind = 'reaction'\nat = 0.25\n",
             "sprung.toml")
      .setup;
}

/// The motion of the spring over its own compliance and the beam's at its place, after Timoshenko:
/// a^2 b^2/3EIL + ab/(kappa G A L) [N].
inline double force_of_spring(const Setup& setup) {
  const Material& material = setup.scene.material;
  const SectionProperties s = section_properties(setup.scene.section, material.poisson_ratio);
  const double length = setup.scene.beam.length;
  const double a = 0.25 * length;
  const double b = length - a;
  const double shear = s.shear_coefficient_y * s.area * material.youngs_modulus /
                       (2.0 * (1.0 + material.poisson_ratio));
  const double give = a * a * b * b / (3.0 * material.youngs_modulus * s.second_moment_x * length) +
                      a * b / (shear * length);
  return -1e-5 / (1e-9 + give);
}

}  // namespace plastica::sweeps
