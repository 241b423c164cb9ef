#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::calibrate {

/// Where a measured beam broke.
struct SceneBreak {
  double at = 0.0;             ///< abscissa [SI]
  double half_interval = 0.0;  ///< it lies anywhere within this on both sides [SI], >= 0
};

/// A measured curve of a beam that a scene can follow: one probe over another, such as a force over
/// the displacement that it makes.
struct SceneTarget {
  std::string name;
  std::vector<double> abscissa;  ///< SI, never falling (n_samples)
  std::vector<double> ordinate;  ///< SI (n_samples)
  std::string abscissa_probe;    ///< names of two of the scene's probes
  std::string ordinate_probe;
  /// Measured = factor x probe, not 0: -1 where the machine counts against the scene's axis.
  double abscissa_factor = 1.0;
  double ordinate_factor = 1.0;
  std::optional<double> noise;  ///< standard deviation of the ordinate [SI], > 0; empty: unknown
  std::optional<SceneBreak> broke;
};

/// Which file and columns hold a measured curve.
struct SceneTargetSource {
  std::string file;
  ColumnSource abscissa;  ///< a name or number; no pattern
  ColumnSource ordinate;
  io::CsvOptions csv;
  SourceLocation where;  ///< of the user's words, for error lines
};

/// Reads a measured curve; units come from the source or the file and must fit the probes.
///
/// A last row whose ordinate is exactly zero, after others that are not, says that the beam broke
/// between the row before and this one.
/// @param probes  its names of probes, factors and noise are kept
/// @throws InputError for a file, column or unit that is missing or does not fit, a cell without a
///         number, an abscissa that goes back, a probe that the scene does not have
SceneTarget read_scene_target(const SceneTargetSource& source, const Scene& scene,
                              SceneTarget probes);

}  // namespace plastica::calibrate
