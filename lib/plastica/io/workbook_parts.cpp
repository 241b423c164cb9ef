#include "plastica/io/workbook_parts.hpp"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <utility>

#include "plastica/base/check.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::io {
namespace {

constexpr std::size_t kMaxRows = std::size_t{1} << 20U, kMaxColumns = std::size_t{1} << 14U;

/// Whether a number format shows its numbers as percent: a % does that is neither in quotes nor
/// behind a sign that makes a character of the next one (ECMA-376, 18.8.31).
bool multiplies_by_100(std::string_view code) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == '"') {
      is_quoted = !is_quoted;
    } else if (!is_quoted && (c == '\\' || c == '_' || c == '*')) {
      ++i;
    } else if (!is_quoted && c == '%') {
      return true;
    }
  }
  return false;
}

/// An archive's parts by their names.
class Archive {
 public:
  explicit Archive(const std::string& path) : path_(path), zip_(unzOpen64(path.c_str())) {
    if (!zip_) refuse_workbook(path, "is a damaged archive, no Excel workbook");
  }

  bool has(const std::string& part) const {
    return unzLocateFile(zip_.get(), part.c_str(), kIgnoreCase) == UNZ_OK;
  }

  pugi::xml_document read(const std::string& part) const {
    if (!has(part))
      refuse_workbook(path_, "is no Excel workbook, or a damaged one: it has no " + part);
    unz_file_info64 info{};
    unzGetCurrentFileInfo64(zip_.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0);
    if (info.uncompressed_size > kMaxTableBytes) {
      refuse_workbook(path_, part + " in it is larger than 1 GiB, the most that is read");
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
      refuse_workbook(path_, "is damaged: its part " + part + " cannot be read");
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

/// "AB12": column 27, from 0.
std::optional<std::size_t> column_of(std::string_view place) {
  std::size_t column = 0, letters = 0;
  while (letters < place.size() && place[letters] >= 'A' && place[letters] <= 'Z') {
    column = 26 * column + static_cast<std::size_t>(place[letters++] - 'A' + 1);
    if (column > kMaxColumns) return std::nullopt;
  }
  return letters == 0 ? std::nullopt : std::optional(column - 1);
}

}  // namespace

void refuse_workbook(const std::string& path, const std::string& rule) {
  throw InputError({path, 0}, "", "", rule);
}

class Workbook::Parts {
 public:
  explicit Parts(const std::string& path) : path_(path), archive_(path) {
    const pugi::xml_document book = archive_.read("xl/workbook.xml");
    const pugi::xml_document links = archive_.read("xl/_rels/workbook.xml.rels");
    std::map<std::string, std::string> part_of, part_by_kind;
    for_children(child_of(links, "Relationships"), "Relationship", [&](const auto& link) {
      const std::string part = place_of(std::string(attribute(link, "Target")));
      const std::string_view type = attribute(link, "Type");
      part_of.emplace(attribute(link, "Id"), part);
      part_by_kind.emplace(type.substr(type.rfind('/') + 1), part);
    });
    for_children(child_of(child_of(book, "workbook"), "sheets"), "sheet", [&](const auto& sheet) {
      // "id" of the relation; "sheetId" is another number.
      sheets_.push_back({std::string(attribute(sheet, "name")),
                         part_of[std::string(attribute(sheet, "id"))],
                         attribute(sheet, "state").ends_with("idden")});
    });
    if (sheets_.empty()) refuse_workbook(path_, "is a workbook without sheets");
    const auto part = [&](const char* kind, const char* usual) {
      const auto found = part_by_kind.find(kind);
      return found != part_by_kind.end() ? found->second : std::string(usual);
    };
    read_strings(part("sharedStrings", "xl/sharedStrings.xml"));
    read_styles(part("styles", "xl/styles.xml"));
  }

  const std::vector<Sheet>& sheets() const { return sheets_; }

  std::vector<Row> rows_of(const std::string& part) const {
    std::vector<Row> rows;
    if (!archive_.has(part)) refuse_workbook(path_, "is damaged: a sheet is missing, " + part);
    const pugi::xml_document document = archive_.read(part);
    for_children(child_of(child_of(document, "worksheet"), "sheetData"), "row",
                 [&](const pugi::xml_node& node) {
                   const std::size_t before = rows.empty() ? 0 : rows.back().number;
                   Row& row = rows.emplace_back();
                   row.number = before + 1;
                   const std::string_view number = attribute(node, "r");
                   std::from_chars(number.data(), number.data() + number.size(), row.number);
                   if (row.number <= before || row.number > kMaxRows) {
                     refuse_workbook(path_, "is damaged: the rows of a sheet are not in order");
                   }
                   for_children(node, "c", [&](const pugi::xml_node& cell) { add(cell, row); });
                 });
    return rows;
  }

 private:
  /// A part's place in the archive, of what a relation of the workbook names.
  static std::string place_of(std::string target) {
    if (target.starts_with('/')) return target.substr(1);
    while (target.starts_with("./")) target.erase(0, 2);
    return "xl/" + target;
  }

  void read_strings(const std::string& part) {
    if (!archive_.has(part)) return;
    const pugi::xml_document strings = archive_.read(part);
    for_children(child_of(strings, "sst"), "si",
                 [&](const pugi::xml_node& item) { add_text(item, strings_.emplace_back()); });
  }

  void read_styles(const std::string& part) {
    if (!archive_.has(part)) return;
    const pugi::xml_document styles = archive_.read(part);
    const pugi::xml_node sheet = child_of(styles, "styleSheet");
    std::vector<std::string_view> percent{"9", "10"};  // those that need no code
    for_children(child_of(sheet, "numFmts"), "numFmt", [&](const pugi::xml_node& format) {
      const std::string_view code = attribute(format, "formatCode");
      if (multiplies_by_100(code)) percent.push_back(attribute(format, "numFmtId"));
    });
    for_children(child_of(sheet, "cellXfs"), "xf", [&](const pugi::xml_node& style) {
      percent_styles_.push_back(std::ranges::find(percent, attribute(style, "numFmtId")) !=
                                percent.end());
    });
  }

  bool is_percentage(std::string_view style) const {
    std::size_t index = percent_styles_.size();
    std::from_chars(style.data(), style.data() + style.size(), index);
    return index < percent_styles_.size() && percent_styles_[index];
  }

  void add(const pugi::xml_node& node, Row& row) const {
    const std::size_t next = row.cells.empty() ? 0 : row.cells.back().column + 1;
    const std::string_view place = attribute(node, "r");
    const auto column = place.empty() ? std::optional(next) : column_of(place);
    if (!column || *column < next || *column >= kMaxColumns) {
      refuse_workbook(path_, "is damaged: the cells of a row are not in order");
    }
    Cell cell{*column, child_of(node, "v").text().get(), false, false};
    if (child_of(node, "f") && !child_of(node, "v")) {
      refuse_workbook(path_, "has formulas without their results: open it in Excel and save it");
    }
    const std::string_view type = attribute(node, "t");
    if (type == "s") {
      std::size_t index = strings_.size();
      std::from_chars(cell.text.data(), cell.text.data() + cell.text.size(), index);
      if (index >= strings_.size()) refuse_workbook(path_, "is damaged: a cell has no text");
      cell.text = strings_[index];
    } else if (type == "inlineStr") {
      cell.text.clear();
      add_text(child_of(node, "is"), cell.text);
    } else if (type == "e") {
      cell.text = "NaN";
    } else {
      cell.is_number = type != "str" && type != "d" && !cell.text.empty();
      cell.is_percentage = cell.is_number && is_percentage(attribute(node, "s"));
    }
    if (!cell.text.empty()) row.cells.push_back(std::move(cell));
  }

  std::string path_;
  Archive archive_;
  std::vector<Sheet> sheets_;
  std::vector<std::string> strings_;
  std::vector<bool> percent_styles_;  ///< of cells, by their style
};

Workbook::Workbook(const std::string& path) : parts_(std::make_unique<Parts>(path)) {}
Workbook::~Workbook() = default;

const std::vector<Sheet>& Workbook::sheets() const { return parts_->sheets(); }

std::vector<Row> Workbook::rows_of(const Sheet& sheet) const { return parts_->rows_of(sheet.part); }

}  // namespace plastica::io
