#pragma once

#include <string>

#include "sweeps/plan/sweep.hpp"

namespace plastica::sweeps {

/// A sweep of the shipped cantilever; `rest` begins with its axes.
inline Sweep cantilever_sweep(const std::string& rest) {
  return parse_sweep("scene = \"../scenes/cantilever.toml\"\n" + rest,
                     std::string(PLASTICA_SOURCE_DIR) + "/data/sweeps/test.toml");
}

/// The tip against the elastica.
inline const std::string kTipError = "[error]\nprobe = \"tip\"\nagainst = \"theory:elastica\"\n";

/// One axis of segment counts.
inline std::string segments_axis(const std::string& values) {
  return "[[axis]]\nfield = \"beam.segments\"\nvalues = " + values + "\n";
}

}  // namespace plastica::sweeps
