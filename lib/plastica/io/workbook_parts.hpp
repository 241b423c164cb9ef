#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

/// The parts of an Excel workbook: an archive of XML files; not installed.
namespace plastica::io {

struct Cell {
  std::size_t column = 0;
  std::string text;
  bool is_number = false;
  bool is_percentage = false;  ///< shown times 100
};

struct Row {
  std::size_t number = 0;  ///< from 1
  std::vector<Cell> cells;
};

struct Sheet {
  std::string name;
  std::string part;
  bool is_hidden = false;
};

/// Reads the sheets of a workbook. Parts are found by the relations that name them.
class Workbook {
 public:
  /// @throws InputError if it is none, or damaged
  explicit Workbook(const std::string& path);
  ~Workbook();
  Workbook(const Workbook&) = delete;
  Workbook& operator=(const Workbook&) = delete;

  const std::vector<Sheet>& sheets() const;
  /// The rows of a sheet that have cells, and of these those that are not empty, in their order.
  /// @throws InputError if they are not in order, or a formula has no result
  std::vector<Row> rows_of(const Sheet& sheet) const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

/// @throws InputError {path}: rule
[[noreturn]] void refuse_workbook(const std::string& path, const std::string& rule);

}  // namespace plastica::io
