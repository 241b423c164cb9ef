#pragma once

#include <string>

#include "plastica/io/text_file.hpp"

/// Scenes in motion that an engine can run.
namespace plastica::testing {

/// Half a metre of plastic, 20 x 4 mm, clamped at its start.
inline std::string plastic_strip(const std::string& solver, const std::string& rest,
                                 const std::string& height = "4 mm") {
  return "[material]\nyoungs_modulus = '2 GPa'\npoisson_ratio = 0.35\ndensity = '1200 kg/m^3'\n"
         "[beam]\nlength = '0.5 m'\nsegments = 16\n"
         "section = { shape = 'rectangle', width = '20 mm', height = '" +
         height +
         "' }\n[rules]\nyield_model = 'elastic'\n"
         "[solver]\nanalysis = 'dynamics'\ntime_step = '1 ms'\nframes = 1\n" +
         solver + "[[support]]\nat = 'start'\nkind = 'clamp'\n" + rest;
}

inline std::string tip_probe(const std::string& component) {
  return "[[probe]]\nname = 'tip_" + component +
         "'\nkind = 'displacement'\nat = 'end'\ncomponent = '" + component + "'\n";
}

/// Gravity takes hold of it at once: seven swings.
inline std::string released_strip() {
  return plastic_strip("duration = '1 s'\nsteps = 50\n",
                       "[gravity]\nacceleration = ['0 m/s^2', '-9.81 m/s^2', '0 m/s^2']\n"
                       "history = 'constant'\n" +
                           tip_probe("y"));
}

/// A force at the tip that is there from the beginning.
inline std::string struck_bar() {
  return plastic_strip("duration = '300 ms'\nsteps = 60\n",
                       "[[load]]\nat = 'end'\nforce = ['0 N', '0.2 N', '0 N']\n"
                       "history = 'constant'\n" +
                           tip_probe("y"));
}

/// A soft strip that gravity bends down by most of its length.
inline std::string swung_strip() {
  return plastic_strip("duration = '800 ms'\nsteps = 40\n",
                       "[gravity]\nacceleration = ['0 m/s^2', '-9.81 m/s^2', '0 m/s^2']\n"
                       "history = 'constant'\n" +
                           tip_probe("y") + tip_probe("z"),
                       "1.5 mm");
}

/// Bent about both axes, and twisted by that, while gravity acts.
inline std::string biaxial_bar() {
  return plastic_strip("duration = '300 ms'\nsteps = 30\n",
                       "[gravity]\nacceleration = ['0 m/s^2', '-9.81 m/s^2', '0 m/s^2']\n"
                       "history = 'constant'\n"
                       "[[load]]\nat = 'end'\nforce = ['3 N', '0 N', '0 N']\n"
                       "history = { smooth_step = ['0 s', '100 ms'] }\n" +
                           tip_probe("x") + tip_probe("y"),
                       "6 mm");
}

/// The shipped arm, whose clamp turns by 60 degrees.
inline std::string robot_arm() {
  return io::read_text_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/robot_arm.toml");
}

/// With a gripper at its end, pushed by a pulse, and damped by its material.
inline std::string damped_arm(const std::string& damping_time = "3 ms") {
  return plastic_strip(
      "duration = '1 s'\nsteps = 50\ndamping = 'stiffness'\n"
      "damping_time = '" +
          damping_time + "'\n",
      "[[mass]]\nat = 'end'\nmass = '30 g'\n"
      "[[load]]\nat = 0.6\nforce = ['0 N', '0.5 N', '0 N']\n"
      "history = { time = ['0 s', '100 ms', '200 ms'], factor = [0, 1, 0] }\n" +
          tip_probe("y"));
}

/// A bar of aluminium with a mass at its end, which a force bends slowly. With explicit dampers
/// runs stay finite at steps that are too long, and are off by half and more.
inline std::string damped_bar(const std::string& damping_time) {
  return "[material]\nname = '6061-T6'\n"
         "[beam]\nlength = '0.8 m'\nsegments = 20\n"
         "section = { shape = 'rectangle', width = '20 mm', height = '8 mm' }\n"
         "[rules]\nyield_model = 'elastic'\n"
         "[solver]\nanalysis = 'dynamics'\nduration = '300 ms'\nsteps = 60\n"
         "time_step = '1 ms'\ndamping = 'stiffness'\ndamping_time = '" +
         damping_time +
         "'\n[[support]]\nat = 'start'\nkind = 'clamp'\n"
         "[[mass]]\nat = 'end'\nmass = '0.2 kg'\n"
         "[[load]]\nat = 'end'\nforce = ['0 N', '-10 N', '0 N']\n"
         "history = { smooth_step = ['0 s', '100 ms'] }\n" +
         tip_probe("y");
}

}  // namespace plastica::testing
