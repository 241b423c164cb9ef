#pragma once

#include <optional>
#include <string>

#include "plastica/io/csv.hpp"

namespace plastica::calibrate {

/// A dimension of the specimen that a file of curves gives.
struct GivenValue {
  double si = 0.0;   ///< [m] or [m^2]
  std::string from;  ///< what gives it: "width 11.6 mm and thickness 3.06 mm of the header"
};

/// What the header lines of a file, and its columns of a single number, say of the specimen.
struct GivenGeometry {
  std::optional<GivenValue> gauge_length;
  std::optional<GivenValue> area;
  std::string without_unit;  ///< a number that would do if it had a unit: "Area = 120.5"
  /// Why none is taken though there are some: ""Area" = 80 mm^2 and "Area 2" = 40 mm^2".
  std::string doubt_of_length, doubt_of_area;
};

/// The gauge length is the original one, not one after the test; the area is given, or made of
/// width and thickness, or of a diameter. A name that is a word of the list goes before one that
/// has it in it; of two that say different things none is taken.
GivenGeometry find_geometry(const io::CsvTable& table);

}  // namespace plastica::calibrate
