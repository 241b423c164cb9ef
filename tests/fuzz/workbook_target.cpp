#include <minizip/zip.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "plastica/io/csv.hpp"
#include "plastica/io/workbook.hpp"
#include "tests/fuzz/fuzz_target.hpp"

/// Workbooks. Bytes that begin as an archive are one as they are; of others an archive is made,
/// since no fuzzer finds what deflates to XML: a line "=== NAME" begins each of its parts.
namespace plastica::fuzz {
namespace {

constexpr std::string_view kPart = "=== ";

void write_part(zipFile zip, std::string_view part) {
  const std::size_t end = std::min(part.find('\n'), part.size());
  const std::string name(part.substr(0, end));
  const std::string_view text = part.substr(std::min(end + 1, part.size()));
  const zip_fileinfo info{};
  // Stored, so that an archive that a seed is made of stays readable.
  zipOpenNewFileInZip64(zip, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, 0, 0, 0);
  zipWriteInFileInZip(zip, text.data(), static_cast<unsigned>(text.size()));
  zipCloseFileInZip(zip);
}

std::string archive_of(std::string_view text) {
  std::string path = scratch_path("fuzzed.xlsx");
  const zipFile zip = zipOpen64(path.c_str(), APPEND_STATUS_CREATE);
  require(zip != nullptr, "cannot write " + path);
  std::size_t begin = text.find(kPart);
  while (begin != std::string_view::npos) {
    const std::size_t next = text.find(kPart, begin + kPart.size());
    write_part(zip, text.substr(begin + kPart.size(), next - begin - kPart.size()));
    begin = next;
  }
  zipClose(zip, nullptr);
  return path;
}

void read_workbook(Bytes bytes) {
  const std::string_view text = text_of(bytes);
  const std::string path =
      text.starts_with("PK") ? scratch_file("fuzzed.xlsx", text) : archive_of(text);
  for (const auto& sheet : {std::optional<std::string>(), std::optional<std::string>("Sheet1")}) {
    read_or_refused([&] { return io::read_sheet(path, sheet, {}); });
  }
  read_or_refused([&] { return io::CsvTable::read(path); });
}

const Registered kWorkbook{"workbook", read_workbook};

}  // namespace
}  // namespace plastica::fuzz
