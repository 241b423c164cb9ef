#include "plastica/io/workbook.hpp"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <pugixml.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

constexpr std::size_t kMaxRows = std::size_t{1} << 20U, kMaxColumns = std::size_t{1} << 14U;

[[noreturn]] void refuse(const std::string& path, std::string rule) {
  throw InputError({path, 0}, "", "", std::move(rule));
}

/// An archive's parts by their names.
class Archive {
 public:
  explicit Archive(const std::string& path) : path_(path), zip_(unzOpen64(path.c_str())) {
    if (!zip_) refuse(path, "is a damaged archive, no Excel workbook");
  }

  bool has(const std::string& part) const {
    return unzLocateFile(zip_.get(), part.c_str(), kIgnoreCase) == UNZ_OK;
  }

  pugi::xml_document read(const std::string& part) const {
    if (!has(part)) refuse(path_, "is no Excel workbook, or a damaged one: it has no " + part);
    unz_file_info64 info{};
    unzGetCurrentFileInfo64(zip_.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0);
    if (info.uncompressed_size > kMaxTableBytes) {
      refuse(path_, part + " in it is larger than 1 GiB, the most that is read");
    }
    std::string bytes;
    std::array<char, 1U << 16U> block{};
    bool is_good = unzOpenCurrentFile(zip_.get()) == UNZ_OK;
    while (is_good) {
      const int count = unzReadCurrentFile(zip_.get(), block.data(), block.size());
      if (count == 0) break;
      is_good = count > 0 && bytes.size() <= kMaxTableBytes;
      if (is_good) bytes.append(block.data(), static_cast<std::size_t>(count));
    }
    // Also says whether the checksum holds.
    is_good = unzCloseCurrentFile(zip_.get()) == UNZ_OK && is_good;
    pugi::xml_document document;
    if (!is_good || !document.load_buffer(bytes.data(), bytes.size(),
                                          pugi::parse_default | pugi::parse_ws_pcdata)) {
      refuse(path_, "is damaged: its part " + part + " cannot be read");
    }
    return document;
  }

 private:
  static constexpr int kIgnoreCase = 2;
  struct Close {
    void operator()(void* zip) const { unzClose(zip); }
  };
  std::string path_;
  std::unique_ptr<void, Close> zip_;
};

/// "row" of "row" and of "x:row": some programs name their elements so.
std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

template <typename Each>
void for_children(const pugi::xml_node& node, std::string_view name, const Each& each) {
  for (const pugi::xml_node& child : node.children()) {
    if (local_name(child.name()) == name) each(child);
  }
}

pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
  pugi::xml_node found;
  for_children(node, name, [&](const pugi::xml_node& child) {
    if (!found) found = child;
  });
  return found;
}

std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& one : node.attributes()) {
    if (local_name(one.name()) == name) return one.value();
  }
  return {};
}

/// The text of a string: all of its runs, without how they are read aloud.
void add_text(const pugi::xml_node& node, std::string& text) {
  for (const pugi::xml_node& child : node.children()) {
    const std::string_view name = local_name(child.name());
    if (name == "t") text += child.text().get();
    if (name == "r") add_text(child, text);
  }
}

struct Cell {
  std::size_t column = 0;
  std::string text;
  bool is_number = false;
};

struct Row {
  std::size_t number = 0;  ///< from 1
  std::vector<Cell> cells;
};

/// "AB12": column 27, from 0.
std::optional<std::size_t> column_of(std::string_view place) {
  std::size_t column = 0, letters = 0;
  while (letters < place.size() && place[letters] >= 'A' && place[letters] <= 'Z') {
    column = 26 * column + static_cast<std::size_t>(place[letters++] - 'A' + 1);
    if (column > kMaxColumns) return std::nullopt;
  }
  return letters == 0 ? std::nullopt : std::optional(column - 1);
}

class Workbook {
 public:
  explicit Workbook(const std::string& path) : path_(path), archive_(path) {
    const pugi::xml_document book = archive_.read("xl/workbook.xml");
    const pugi::xml_document links = archive_.read("xl/_rels/workbook.xml.rels");
    const auto target_of = [&](std::string_view id) {
      std::string target;
      for_children(child_of(links, "Relationships"), "Relationship", [&](const auto& link) {
        if (attribute(link, "Id") == id) target = attribute(link, "Target");
      });
      return target.starts_with('/') ? target.substr(1) : "xl/" + target;
    };
    for_children(child_of(child_of(book, "workbook"), "sheets"), "sheet", [&](const auto& sheet) {
      // "id" of the relation; "sheetId" is another number.
      sheets_.emplace_back(attribute(sheet, "name"), target_of(attribute(sheet, "id")));
    });
    if (sheets_.empty()) refuse(path_, "is a workbook without sheets");
    if (!archive_.has("xl/sharedStrings.xml")) return;
    const pugi::xml_document strings = archive_.read("xl/sharedStrings.xml");
    for_children(child_of(strings, "sst"), "si",
                 [&](const pugi::xml_node& item) { add_text(item, strings_.emplace_back()); });
  }

  const std::vector<std::pair<std::string, std::string>>& sheets() const { return sheets_; }

  std::vector<Row> rows_of(const std::string& part) const {
    std::vector<Row> rows;
    if (!archive_.has(part)) refuse(path_, "is damaged: a sheet is missing, " + part);
    const pugi::xml_document document = archive_.read(part);
    for_children(child_of(child_of(document, "worksheet"), "sheetData"), "row",
                 [&](const pugi::xml_node& node) {
                   const std::size_t before = rows.empty() ? 0 : rows.back().number;
                   Row& row = rows.emplace_back();
                   row.number = before + 1;
                   const std::string_view number = attribute(node, "r");
                   std::from_chars(number.data(), number.data() + number.size(), row.number);
                   if (row.number <= before || row.number > kMaxRows) {
                     refuse(path_, "is damaged: the rows of a sheet are not in order");
                   }
                   for_children(node, "c", [&](const pugi::xml_node& cell) { add(cell, row); });
                 });
    return rows;
  }

 private:
  void add(const pugi::xml_node& node, Row& row) const {
    const std::size_t next = row.cells.empty() ? 0 : row.cells.back().column + 1;
    const std::string_view place = attribute(node, "r");
    const auto column = place.empty() ? std::optional(next) : column_of(place);
    if (!column || *column < next || *column >= kMaxColumns) {
      refuse(path_, "is damaged: the cells of a row are not in order");
    }
    Cell cell{*column, child_of(node, "v").text().get(), false};
    const std::string_view type = attribute(node, "t");
    if (type == "s") {
      std::size_t index = strings_.size();
      std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), index);
      if (index >= strings_.size()) refuse(path_, "is damaged: a cell has no text");
      cell.text = strings_[index];
    } else if (type == "inlineStr") {
      cell.text.clear();
      add_text(child_of(node, "is"), cell.text);
    } else if (type == "e") {
      cell.text = "NaN";
    } else {
      cell.is_number = type != "str" && type != "d";
    }
    if (!cell.text.empty()) row.cells.push_back(std::move(cell));
  }

  std::string path_;
  Archive archive_;
  std::vector<std::pair<std::string, std::string>> sheets_;  ///< name and part
  std::vector<std::string> strings_;
};

/// Rows with two numbers or more.
std::size_t rows_of_numbers(const std::vector<Row>& rows) {
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](const Row& row) {
    return std::ranges::count_if(row.cells, &Cell::is_number) >= 2;
  }));
}

/// A cell between tabs: no tab, no line end, quoted as CSV does it.
std::string written(const std::string& text) {
  std::string flat = text;
  for (char& c : flat) {
    if (c == '\t' || c == '\n' || c == '\r') c = ' ';
  }
  if (flat.find('"') == std::string::npos) return flat;
  std::string quoted = "\"";
  for (const char c : flat) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

bool is_number_with_comma(const std::string& text) {
  const bool plain = text.find_first_not_of("0123456789,.+-eE ") == std::string::npos;
  return plain && text.find(',') != std::string::npos;
}

SheetText text_of(std::string name, const std::vector<Row>& rows) {
  SheetText sheet{std::move(name), {}, false};
  std::size_t width = 0;
  for (const Row& row : rows) {
    if (!row.cells.empty()) width = std::max(width, row.cells.back().column + 1);
  }
  std::size_t line = 1;
  for (const Row& row : rows) {
    if (row.cells.empty()) continue;
    for (; line < row.number; ++line) sheet.text += '\n';
    std::size_t column = 0;
    for (const Cell& cell : row.cells) {
      for (; column < cell.column; ++column) sheet.text += '\t';
      sheet.text += written(cell.text);
      sheet.has_commas = sheet.has_commas || (!cell.is_number && is_number_with_comma(cell.text));
    }
    for (; column + 1 < width; ++column) sheet.text += '\t';
  }
  if (!sheet.text.empty()) sheet.text += '\n';
  return sheet;
}

}  // namespace

bool is_workbook(const std::string& path) {
  if (!is_file(path)) return false;
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rbe"));
  std::array<char, 4> begin{};
  return file && std::fread(begin.data(), 1, begin.size(), file.get()) == begin.size() &&
         std::memcmp(begin.data(), "PK\x03\x04", begin.size()) == 0;
}

SheetText read_sheet(const std::string& path, const std::optional<std::string>& sheet) {
  constexpr std::size_t kFewRows = 3;
  const Workbook book(path);
  std::string all, with_tables;
  std::optional<SheetText> found;
  std::size_t tables = 0;
  for (const auto& [name, part] : book.sheets()) {
    all += (all.empty() ? "" : ", ") + name;
    if (sheet) {
      if (name == *sheet) return text_of(name, book.rows_of(part));
      continue;
    }
    // Charts and dialogs are sheets, too.
    if (part.find("worksheets/") == std::string::npos) continue;
    const std::vector<Row> rows = book.rows_of(part);
    const std::size_t count = rows_of_numbers(rows);
    if (count < kFewRows) continue;
    with_tables += (tables == 0 ? "" : ", ") + name + " (" + std::to_string(count) + " rows)";
    if (++tables == 1) found = text_of(name, rows);
  }
  if (sheet) {
    throw InputError({path, 0}, "sheet", *sheet, "is no sheet of this workbook, which has " + all);
  }
  if (tables > 1) {
    throw InputError({path, 0}, "sheet", "",
                     "must be named, as several have a table of numbers: " + with_tables);
  }
  if (tables == 0) refuse(path, "has no table of numbers on any of its sheets: " + all);
  return *std::move(found);
}

}  // namespace plastica::io
