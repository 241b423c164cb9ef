#pragma once

#include <string>
#include <vector>

#include "plastica/io/csv.hpp"

namespace plastica::io {

/// A number that a line above the header of a table gives.
struct HeaderEntry {
  std::string name;  ///< as it stands there: "Specimen properties : Width"
  double value = 0.0;
  std::string unit;  ///< as it stands there; may be empty
};

/// The numbers in the lines above the header: `"Section",5.96,"mm²"`, `Width (mm);12,5`,
/// `Gauge length: 50 mm, width: 12 mm`, `# area = 78.5 mm^2`. Left out are lines that give none,
/// rows of several numbers (one for each specimen, or results), and numbers that may be others
/// (`1,200`).
std::vector<HeaderEntry> header_entries(const CsvTable& table);

}  // namespace plastica::io
