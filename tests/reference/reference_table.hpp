#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace plastica::testing {

/// A table of tests/reference: cells by column name; one in double quotes may hold commas. Throws
/// if it cannot be read whole, so that a test over its rows cannot pass on nothing.
class ReferenceTable {
 public:
  /// @param path  below tests/reference: "torsion-rectangle/coefficients.csv"
  explicit ReferenceTable(const std::string& path) {
    std::ifstream file(std::string(PLASTICA_SOURCE_DIR) + "/tests/reference/" + path);
    std::string line;
    std::getline(file, line);
    const std::vector<std::string> names = cells(line);
    while (std::getline(file, line)) {
      const std::vector<std::string> row = cells(line);
      if (row.size() < names.size()) throw std::runtime_error(path + ": a short row");
      for (std::size_t i = 0; i < names.size(); ++i) columns_[names[i]].push_back(row[i]);
      ++rows_;
    }
    if (rows_ == 0) throw std::runtime_error(path + ": no rows");
  }

  std::size_t rows() const { return rows_; }
  /// The number in a cell; "inf" and "nan" are numbers, other text throws.
  double at(const std::string& column, std::size_t row) const {
    return std::stod(text(column, row));
  }
  const std::string& text(const std::string& column, std::size_t row) const {
    return columns_.at(column).at(row);
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> found(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        found.emplace_back();
      } else {
        found.back() += c;
      }
    }
    return found;
  }

  std::map<std::string, std::vector<std::string>> columns_;
  std::size_t rows_ = 0;
};

}  // namespace plastica::testing
