#pragma once

#include <string>
#include <vector>

#include "plastica/model/drive.hpp"
#include "plastica/model/material.hpp"
#include "plastica/model/probe.hpp"
#include "plastica/model/rules.hpp"
#include "plastica/model/section.hpp"

namespace plastica {

/// The beam's axis and how it is divided.
struct Beam {
  double length = 1.0;  ///< [m], > 0
  int segments = 10;    ///< number of rigid segments, >= 1; l = length/segments at inner joints
};

/// All that a simulation needs to know about the beam and what is done to it; a plain value.
struct Scene {
  std::string name;
  Material material;
  Section section;
  Beam beam;
  Drive drive;
  std::vector<Probe> probes{{"stress", ProbeQuantity::Stress}};
  Formulas formulas = Formulas::Mechanics;
  YieldCap yield_cap = YieldCap::FirstYield;
  BreakMeasure break_measure = BreakMeasure::Net;
  BreakPolicy on_break = BreakPolicy::CutAll;
};

/// How a scene is solved.
struct SolverOptions {
  Level level = Level::Auto;
};

/// @throws InputError naming the first field that is out of range or does not fit the others
void check_scene(const Scene& scene, const SolverOptions& options);

}  // namespace plastica
