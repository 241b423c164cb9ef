#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace plastica::testing {

/// A table of tests/reference: numbers by column name. Throws if it cannot be read whole, so that a
/// test over its rows cannot pass on nothing.
class ReferenceTable {
 public:
  /// @param path  below tests/reference: "torsion-rectangle/coefficients.csv"
  explicit ReferenceTable(const std::string& path) {
    std::ifstream file(std::string(PLASTICA_SOURCE_DIR) + "/tests/reference/" + path);
    std::vector<std::string> names;
    std::string line;
    std::string cell;
    std::getline(file, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
    while (std::getline(file, line)) {
      std::istringstream cells(line);
      for (const std::string& name : names) {
        if (!std::getline(cells, cell, ',')) throw std::runtime_error(path + ": a short row");
        columns_[name].push_back(std::stod(cell));
      }
      ++rows_;
    }
    if (rows_ == 0) throw std::runtime_error(path + ": no rows");
  }

  std::size_t rows() const { return rows_; }
  double at(const std::string& column, std::size_t row) const {
    return columns_.at(column).at(row);
  }

 private:
  std::map<std::string, std::vector<double>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace plastica::testing
