#pragma once

#include <minizip/zip.h>

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace plastica::testing {

/// A cell as XML: `<c r="A1" ...>` is put around it by `sheet_xml`.
struct SheetCell {
  std::string xml;
};

inline SheetCell number_cell(const std::string& value) { return {" ><v>" + value + "</v>"}; }
inline SheetCell text_cell(const std::string& text) {
  return {" t=\"inlineStr\"><is><t>" + text + "</t></is>"};
}
inline SheetCell shared_cell(int index) {
  return {" t=\"s\"><v>" + std::to_string(index) + "</v>"};
}
inline SheetCell error_cell() { return {" t=\"e\"><v>#DIV/0!</v>"}; }
inline SheetCell no_cell() { return {}; }

/// Rows from the first on; an empty row stands nowhere in the file.
inline std::string sheet_xml(const std::vector<std::vector<SheetCell>>& rows) {
  std::string text = "<worksheet><sheetData>";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (rows[r].empty()) continue;
    const std::string number = std::to_string(r + 1);
    text += "<row r=\"" + number + "\">";
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      if (rows[r][c].xml.empty()) continue;
      text += "<c r=\"" + std::string(1, static_cast<char>('A' + c)) + number + "\"" +
              rows[r][c].xml + "</c>";
    }
    text += "</row>";
  }
  return text + "</sheetData></worksheet>";
}

/// Writes an archive of parts: names and texts.
inline void write_archive(const std::string& path,
                          const std::vector<std::pair<std::string, std::string>>& parts) {
  zipFile zip = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
  if (zip == nullptr) throw std::runtime_error("cannot write " + path);
  for (const auto& [name, text] : parts) {
    const zip_fileinfo info{};
    zipOpenNewFileInZip64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                          Z_DEFAULT_COMPRESSION, 0);
    zipWriteInFileInZip(zip, text.data(), static_cast<unsigned>(text.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
}

/// A workbook of sheets: names and XML. The shared texts are those of `shared`.
inline void write_workbook(const std::string& path,
                           const std::vector<std::pair<std::string, std::string>>& sheets,
                           const std::vector<std::string>& shared = {}) {
  std::string book = "<workbook><sheets>", links = "<Relationships>", texts = "<sst>";
  std::vector<std::pair<std::string, std::string>> parts;
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    // Sheets are not in the order of their files.
    const std::string id = "rId" + std::to_string(sheets.size() - i);
    const std::string part = "worksheets/sheet" + std::to_string(i + 1) + ".xml";
    book += "<sheet name=\"" + sheets[i].first + "\" sheetId=\"7\" r:id=\"" + id + "\"/>";
    links += "<Relationship Id=\"" + id + "\" Target=\"" + part + "\"/>";
    parts.emplace_back("xl/" + part, sheets[i].second);
  }
  for (const std::string& text : shared) texts += "<si>" + text + "</si>";
  parts.emplace_back("xl/workbook.xml", book + "</sheets></workbook>");
  parts.emplace_back("xl/_rels/workbook.xml.rels", links + "</Relationships>");
  if (!shared.empty()) parts.emplace_back("xl/sharedStrings.xml", texts + "</sst>");
  write_archive(path, parts);
}

}  // namespace plastica::testing
