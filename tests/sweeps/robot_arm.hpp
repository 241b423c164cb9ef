#pragma once

#include <string>

#include "plastica/io/scene_file.hpp"
#include "plastica/run/simulate.hpp"

namespace plastica::sweeps {

/// A shipped scene. @param name  "robot_arm"
inline Setup shipped_scene(const std::string& name) {
  return io::read_scene_file(std::string(PLASTICA_SOURCE_DIR) + "/data/scenes/" + name + ".toml")
      .setup;
}

/// Where the gripper of the shipped arm of a robot ends [m], with a discretization of its own.
inline double gripper_end(int segments, double time_step) {
  Setup arm = shipped_scene("robot_arm");
  arm.scene.beam.segments = segments;
  arm.solver.time_step = time_step;
  return simulate(arm.scene, arm.solver).probes[0].back();
}

}  // namespace plastica::sweeps
