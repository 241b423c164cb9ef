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
};

/// The gauge length is the original one, not one after the test; the area is given, or made of a
/// diameter, or of width and thickness.
GivenGeometry find_geometry(const io::CsvTable& table);

}  // namespace plastica::calibrate
