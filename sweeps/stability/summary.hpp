#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sweeps/stability/stability.hpp"

namespace plastica::sweeps::stability {

/// How many points of a level are in each class, in the order of Validity.
struct LevelCount {
  Level level = Level::Planar;
  Analysis analysis = Analysis::Statics;
  std::array<std::size_t, 4> points{};
};

/// Counts of rows by level and analysis, those that have any, from the least level up.
std::vector<LevelCount> count_validity(std::span<const StabilityRow> rows);

/// Between which values of an axis all scenes of a level are valid.
struct SafeRange {
  Level level = Level::Planar;
  Analysis analysis = Analysis::Statics;
  std::string axis;
  std::string unit;
  std::size_t scenes = 0;  ///< that are scanned along the axis
  double low = 0.0;   ///< the widest range around the scenes' normal values in which every point
  double high = 0.0;  ///< is valid
  bool open_low = false;  ///< whether the range ends where the scan does, not at an invalid point
  bool open_high = false;
};

/// Safe ranges of the scans along one axis; those of two are in the map alone.
std::vector<SafeRange> safe_ranges(std::span<const StabilityRow> rows);

/// The counts and the safe ranges as tables of Markdown.
std::string summary_text(std::span<const StabilityRow> rows);

/// All rows as CSV: id, level, analysis, axes, verdict, reason, status, energy balance error,
/// segment-steps, seconds.
std::string rows_csv(std::span<const StabilityRow> rows);

/// Word of a level: "planar".
std::string_view word_of(Level level);

}  // namespace plastica::sweeps::stability
