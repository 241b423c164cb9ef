#include "plastica/report/table.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "plastica/report/format.hpp"

namespace plastica::report {
namespace {

constexpr std::string_view kGap = "  ";

std::string_view separator_of(Table::Align align) {
  if (align == Table::Align::PlusMinus) return " ± ";
  return align == Table::Align::Range ? " … " : std::string_view();
}

/// Widths of what stands left and right of a column's separator; `right` counts the separator.
struct Widths {
  std::size_t left = 0;
  std::size_t right = 0;
  std::size_t whole = 0;
};

std::size_t split_at(std::string_view cell, Table::Align align) {
  const std::string_view separator = separator_of(align);
  return separator.empty() ? std::string_view::npos : cell.find(separator);
}

void measure(std::string_view cell, Table::Align align, Widths& widths) {
  const std::size_t at = split_at(cell, align);
  if (at == std::string_view::npos) {
    widths.left = std::max(widths.left, width_of(cell));
  } else {
    widths.left = std::max(widths.left, width_of(cell.substr(0, at)));
    widths.right = std::max(widths.right, width_of(cell.substr(at)));
  }
  widths.whole = widths.left + widths.right;
}

std::string blanks(std::size_t wanted, std::size_t used) {
  return std::string(wanted > used ? wanted - used : 0, ' ');
}

std::string padded(std::string_view cell, Table::Align align, const Widths& widths) {
  const std::size_t width = width_of(cell);
  if (align == Table::Align::Left) return std::string(cell) + blanks(widths.whole, width);
  const std::size_t at = split_at(cell, align);
  const std::size_t left = at == std::string_view::npos ? width : width_of(cell.substr(0, at));
  const std::size_t slack = widths.whole - (widths.left + widths.right);
  std::string text = blanks(widths.left + slack, left) + std::string(cell);
  return text + blanks(widths.whole, width_of(text));
}

void put_line(std::string& all, std::size_t indent, std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  all += std::string(line.empty() ? 0 : indent, ' ') + line + '\n';
}

}  // namespace

void Table::add(std::vector<std::string> cells) {
  rows_.push_back({Kind::Cells, std::move(cells)});
}

void Table::add_note(std::string note) { rows_.push_back({Kind::Note, {std::move(note)}}); }

void Table::add_line(std::string line) { rows_.push_back({Kind::Line, {std::move(line)}}); }

std::string Table::text(std::size_t indent, std::size_t width) const {
  std::vector<Widths> widths(columns_.size());
  for (const Row& row : rows_) {
    if (row.kind != Kind::Cells) continue;
    for (std::size_t c = 0; c < row.cells.size(); ++c) {
      measure(row.cells[c], columns_[c].align, widths[c]);
    }
  }
  std::size_t total = indent;
  bool headers = false;
  bool units = false;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const std::size_t heading = std::max(width_of(columns_[c].header), width_of(columns_[c].unit));
    widths[c].whole = std::max(widths[c].whole, heading);
    total += widths[c].whole + (c == 0 ? 0 : kGap.size());
    headers = headers || !columns_[c].header.empty();
    units = units || !columns_[c].unit.empty();
  }
  if (total > width) {
    const std::size_t excess = total - width;
    Widths& first = widths.front();
    first.whole = first.whole > excess + 8 ? first.whole - excess : 8;
    first.left = std::min(first.left, first.whole);
  }

  const auto heading = [&](std::size_t c, const std::string& text) {
    const std::string fill = blanks(widths[c].whole, width_of(text));
    return columns_[c].align == Align::Left ? text + fill : fill + text;
  };
  std::string all;
  for (const bool second : {false, true}) {
    if (second ? !units : !headers) continue;
    std::string line;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (c > 0) line += kGap;
      line += heading(c, second ? columns_[c].unit : columns_[c].header);
    }
    put_line(all, indent, std::move(line));
  }
  for (const Row& row : rows_) {
    std::string line;
    if (row.kind == Kind::Cells) {
      for (std::size_t c = 0; c < row.cells.size(); ++c) {
        if (c > 0) line += kGap;
        const std::string cell = c == 0 ? cut(row.cells[c], widths[c].whole) : row.cells[c];
        line += padded(cell, columns_[c].align, widths[c]);
      }
      put_line(all, indent, std::move(line));
    } else if (row.kind == Kind::Note) {
      const std::string start(indent + widths.front().whole + kGap.size(), ' ');
      all += wrapped(start, row.cells.front(), width);
    } else {
      put_line(all, indent, row.cells.front());
    }
  }
  return all;
}

}  // namespace plastica::report
