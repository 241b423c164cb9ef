#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace plastica::report {

/// A table of text with aligned columns.
class Table {
 public:
  enum class Align {
    Left,
    Right,
    PlusMinus,  ///< cells "a ± b": all ± stand below each other
    Range,      ///< cells "a … b": all … stand below each other
  };
  struct Column {
    std::string header;
    Align align = Align::Right;
    std::string unit = {};  ///< a second line of the header; left out if no column has one
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// @param cells  one text per column; columns at the end may be left out
  void add(std::vector<std::string> cells);
  /// A line below the last row, which begins at the second column.
  void add_note(std::string note);
  /// A line across all columns.
  void add_line(std::string line);

  std::size_t rows() const { return rows_.size(); }
  /// The table, every line indented by `indent` and at most `width` columns wide: where it would
  /// be wider, the first column is cut.
  std::string text(std::size_t indent, std::size_t width) const;

 private:
  enum class Kind { Cells, Note, Line };
  struct Row {
    Kind kind = Kind::Cells;
    std::vector<std::string> cells;
  };

  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace plastica::report
