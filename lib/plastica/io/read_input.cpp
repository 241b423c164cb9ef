#include "plastica/io/read_input.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "plastica/base/check.hpp"
#include "plastica/base/utf8.hpp"
#include "plastica/io/utf16.hpp"

namespace plastica::io {
namespace {

std::string shown_size(std::size_t bytes) {
  constexpr std::size_t kMiB = std::size_t{1} << 20U;
  if (bytes % (kMiB << 10U) == 0) return std::to_string(bytes / (kMiB << 10U)) + " GiB";
  if (bytes % kMiB == 0) return std::to_string(bytes / kMiB) + " MiB";
  return std::to_string(bytes) + " bytes";
}

InputError too_large(const std::string& path, std::size_t max_bytes) {
  return {{path, 0}, "", "", "is larger than " + shown_size(max_bytes) + ", the most that is read"};
}

}  // namespace

std::string read_input(const std::string& path, std::size_t max_bytes) {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rbe"));
  const auto refuse = [&] {
    throw InputError({path, 0}, "", "", std::string("cannot be read: ") + std::strerror(errno));
  };
  if (!file) refuse();
  std::string bytes;
  struct stat status {};
  if (fstat(fileno(file.get()), &status) == 0 && S_ISREG(status.st_mode)) {
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > max_bytes) throw too_large(path, max_bytes);
    bytes.reserve(size);
  }
  std::vector<char> block(std::size_t{1} << 18U);
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.append(block.data(), count);
    if (!utf16_order(bytes) && std::memchr(block.data(), 0, count) != nullptr) {
      refuse_binary(bytes, path);
    }
    if (bytes.size() > max_bytes) throw too_large(path, max_bytes);
  }
  if (std::ferror(file.get()) != 0) refuse();
  if (const auto order = utf16_order(bytes)) return utf8_of_utf16(bytes, *order, path);
  return bytes;
}

void refuse_binary(std::string_view bytes, const std::string& file) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kKinds{
      {{"PK\x03\x04",
        "is an Excel workbook or another archive: name the file, or save the sheet as CSV"},
       {"\xD0\xCF\x11\xE0",
        "is an old Excel workbook (.xls), or one with a password: save the sheet as CSV"},
       {"MATLAB 5.0 MAT-file",
        "is a MATLAB file: write the columns with writematrix(data, \"curve.csv\")"}}};
  for (const auto& [begin, rule] : kKinds) {
    if (bytes.starts_with(begin)) throw InputError({file, 0}, "", "", std::string(rule));
  }
  const std::size_t zero = bytes.find('\0');
  if (zero == std::string_view::npos) return;
  const auto line = 1 + std::count(bytes.begin(), bytes.begin() + std::ptrdiff_t(zero), '\n');
  throw InputError({file, static_cast<int>(line)}, "", "", "is not text (it has a zero byte)");
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

bool is_broken_link(const std::filesystem::path& path) {
  std::error_code error;
  const auto type = std::filesystem::status(path, error).type();
  const bool leads_nowhere = type == std::filesystem::file_type::not_found || error;
  return leads_nowhere && std::filesystem::is_symlink(path, error);
}

std::string why_no_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return {};
  if (error) return ": " + std::generic_category().message(error.value());
  switch (status.type()) {
    case std::filesystem::file_type::regular: return {};
    case std::filesystem::file_type::directory: return ": it is a folder";
    default: return ": it is a pipe or a device";
  }
}

}  // namespace plastica::io
