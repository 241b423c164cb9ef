#pragma once

#include "plastica/io/scene_file.hpp"

namespace plastica::sweeps {

/// An elastic beam, clamped and propped, whose load and probe stand at the same part of a segment
/// with 4 segments and with 8: the probe is at -1.129, -1.122, -0.771 ... -0.659 mm with 4, 8, 16
/// ... 2000, so that 4 and 8 agree, and are 71 % off.
inline Setup places_alike(int segments) {
  Setup setup = io::parse_scene_file(
                    "material = 'S355'\n[beam]\nlength = '4 m'\nsegments = 32\n"
                    "section = { shape = 'rectangle', width = '20 mm', height = '20 mm' }\n"
                    "[rules]\nyield_model = 'elastic'\n[solver]\nsteps = 1\n"
                    "[[support]]\nat = 'start'\nkind = 'clamp'\n"
                    "[[support]]\nat = 'end'\nkind = 'roller'\nhold = ['y']\n"
                    "[[load]]\nat = 0.13\nforce = ['0 N', '-60 N', '0 N']\n"
                    "[[probe]]\nname = 'tip'\nkind = 'displacement'\nat = 0.12\ncomponent = 'y'\n",
                    "propped.toml")
                    .setup;
  setup.scene.beam.segments = segments;
  return setup;
}

}  // namespace plastica::sweeps
