#include "calibrate/config/find_files.hpp"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

namespace plastica::calibrate {
namespace {

struct GlobResult {
  glob_t paths{};
  GlobResult() = default;
  GlobResult(const GlobResult&) = delete;
  GlobResult& operator=(const GlobResult&) = delete;
  ~GlobResult() { globfree(&paths); }
};

}  // namespace

std::string literal_pattern(const std::string& path) {
  std::string text;
  for (const char c : path) {
    if (std::string_view("*?[]{}\\~,").find(c) != std::string_view::npos) text += '\\';
    text += c;
  }
  return text;
}

std::vector<std::string> find_files(const std::string& folder, const std::string& pattern) {
  const bool relative = !std::filesystem::path(pattern).is_absolute();
  const std::string whole =
      relative && !folder.empty() ? literal_pattern(folder) + "/" + pattern : pattern;
  GlobResult found;
  const int code = glob(whole.c_str(), GLOB_BRACE, nullptr, &found.paths);
  if (code == GLOB_NOSPACE) throw std::bad_alloc();
  std::vector<std::string> files;
  for (std::size_t i = 0; i < found.paths.gl_pathc; ++i) {
    std::string file = found.paths.gl_pathv[i];
    if (std::filesystem::is_regular_file(file)) files.push_back(std::move(file));
  }
  // Not glob's own order, which follows the locale; two parts of a {a,b} may match the same file.
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace plastica::calibrate
