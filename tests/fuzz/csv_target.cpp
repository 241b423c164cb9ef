#include <cstddef>
#include <string>
#include <vector>

#include "calibrate/guess/guess_file.hpp"
#include "plastica/io/csv.hpp"
#include "plastica/io/csv_column.hpp"
#include "plastica/io/csv_header.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Delimited text: separator, decimal mark, header and units are found out from it, columns and
/// geometry guessed.
namespace plastica::fuzz {
namespace {

/// By the number of bytes, so that seeds are plain tables; mostly all is found out.
io::CsvOptions csv_options_for(std::size_t bytes) {
  io::CsvOptions options;
  switch (bytes % 16) {
    case 1: options.separator = ';'; break;
    case 2: options.separator = ' '; break;
    case 3: options.decimal = ','; break;
    case 4: options.header = 0; break;
    case 5: options.header = 2; break;
    case 6:
      options.separator = '\t';
      options.decimal = '.';
      options.header = 1;
      break;
    default: break;
  }
  return options;
}

/// A table has a name, a unit and a line for all that it has.
void check_table(const io::CsvTable& table) {
  require(table.columns() > 0 && table.rows() > 0, "a table without cells");
  require(table.units().size() == table.columns(), "not a unit for each column");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    require(table.line_of_row(row) > 0, "a row without a line");
    for (std::size_t k = 0; k < table.columns(); ++k) {
      require(table.cell(row, k).find('\n') == std::string_view::npos, "a cell of two lines");
    }
  }
}

void read_columns(const io::CsvTable& table) {
  for (std::size_t k = 0; k < table.columns(); ++k) {
    read_or_refused([&] { return table.numbers(k); });
    const io::NamedColumn column{std::to_string(k + 1), {}, {table.file(), 1}, "column"};
    for (const Dimension dimension : {Dimension::Stress, Dimension::Strain}) {
      read_or_refused([&] { return io::read_column(table, column, dimension); });
    }
    read_or_refused([&] { return table.find(table.names()[k], {}, "column"); });
  }
}

void read_csv(Bytes bytes) {
  const auto table = result_or_refused([&] {
    return io::CsvTable::parse(text_of(bytes), "fuzzed.csv", csv_options_for(bytes.size()));
  });
  if (!table) return;
  check_table(*table);
  read_columns(*table);
  read_or_refused([&] { return io::header_entries(*table); });
  read_or_refused([&] { return calibrate::guess_file(*table); });
}

const Registered kCsv{"csv", read_csv};

}  // namespace
}  // namespace plastica::fuzz
