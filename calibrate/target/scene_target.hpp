#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/target/import.hpp"
#include "calibrate/target/options.hpp"
#include "plastica/base/quantity.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/model/scene.hpp"

namespace plastica::calibrate {

/// Where a measured beam broke.
struct SceneBreak {
  double at = 0.0;             ///< abscissa [SI]
  double half_interval = 0.0;  ///< it lies anywhere within this on both sides [SI], >= 0
  std::size_t cut = 0;         ///< samples after it, which were measured and do not count

  /// Where it is known to be broken, coming from a last intact sample.
  double broken_from(double last) const {
    return at < last ? at - half_interval : at + half_interval;
  }
};

/// What a measured abscissa is in the scene.
enum class Abscissa {
  Probe,    ///< what a probe says along the scene's own path, on which it grows
  Time,     ///< the time of a motion [s]
  Support,  ///< how far a support has moved or turned: it follows what was measured
  Load,     ///< the size of a load, likewise
  Strain,   ///< that of a coupon, likewise
};

/// Whether the scene follows the measured values, up and down, in place of its own history.
constexpr bool is_driven(Abscissa kind) { return kind >= Abscissa::Support; }

/// A measured curve of a beam that a scene can follow, such as a force over the displacement that
/// it makes.
struct SceneTarget {
  std::string name;
  /// Which [[target]] of the fit file it stands in, from 1 on; 0: not known.
  std::size_t table = 0;
  Abscissa kind = Abscissa::Probe;
  std::size_t driven = 0;  ///< which support or load follows
  /// SI (n_samples); any path if the scene is driven by it, else never falling.
  std::vector<double> abscissa;
  std::vector<double> ordinate;             ///< SI (n_samples)
  std::string abscissa_probe;               ///< one of the scene's, of Abscissa::Probe
  std::string ordinate_probe;               ///< another
  Dimension abscissa_is = Dimension::None;  ///< what the numbers measure, for reports
  Dimension ordinate_is = Dimension::None;
  /// Measured = factor x the scene's, not 0: -1 where the machine counts against its axis.
  double abscissa_factor = 1.0;
  double ordinate_factor = 1.0;
  std::optional<double> noise;  ///< standard deviation of the ordinate [SI], > 0; empty: unknown
  std::optional<SceneBreak> broke;
  std::vector<Repair> repairs;        ///< done to the samples, as of a coupon
  std::vector<std::string> warnings;  ///< of the reading, for the fit's; not stored
  /// For error lines: of the probe or drive of the abscissa, and of the probe of the ordinate.
  SourceLocation abscissa_where{}, ordinate_where{};
};

/// Which file and columns hold a measured curve.
struct SceneTargetSource {
  std::string file;
  ColumnSource abscissa;  ///< a name or number; no pattern
  ColumnSource ordinate;
  io::CsvOptions csv;
  /// At the break, see scene_break.hpp; amount: the abscissa [SI] beyond which the beam is broken.
  CorrectionChoice trim{};
  /// How far the abscissa may run back, as noise of its measurement [SI], >= 0; empty: by
  /// `kReversalFraction` of its range under load. One that the scene follows is left as it is, if
  /// empty.
  std::optional<double> reversal_tolerance{};
};

inline constexpr double kReversalFraction = 1e-3;

/// Reads a measured curve; units come from the source or the file and must fit the probes.
///
/// In this order, with a repair for each (samples.hpp): rows that lack a number and repeated
/// samples are dropped, and lone outliers unless over time or where the abscissa turns round. An
/// ordinate that falls to zero and stays there says that the beam broke (scene_break.hpp). Last,
/// unless the scene follows the abscissa, samples at which it runs back within the tolerance are
/// averaged: "abscissa-reversals".
/// @param probes  its names of probes, factors and noise are kept
/// @throws InputError for a file, column or unit that is missing or does not fit, a cell of words,
///         an abscissa that goes back further, a row without an ordinate where a path that the
///         scene follows turns, a probe that the scene does not have
SceneTarget read_scene_target(const SceneTargetSource& source, const Scene& scene,
                              SceneTarget probes);

}  // namespace plastica::calibrate
