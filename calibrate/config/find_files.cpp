#include "calibrate/config/find_files.hpp"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

#include "plastica/io/read_input.hpp"

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

std::string too_many_braces(std::string_view pattern) {
  constexpr std::size_t kMaxPatterns = 10'000;
  constexpr std::size_t kMaxBraces = 100;
  struct Braces {
    std::size_t done = 0;    // patterns of the alternatives before the last comma
    std::size_t so_far = 1;  // of the one behind it
  };
  std::vector<Braces> open(1);
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    if (c == '\\') {
      ++i;
    } else if (c == '{') {
      if (++pairs > kMaxBraces) return "has more than " + std::to_string(kMaxBraces) + " braces";
      open.emplace_back();
    } else if (c == ',' && open.size() > 1) {
      open.back().done += open.back().so_far;
      open.back().so_far = 1;
    } else if (c == '}' && open.size() > 1) {
      const std::size_t patterns = open.back().done + open.back().so_far;
      open.pop_back();
      open.back().so_far *= patterns;
    }
    if (open.back().done + open.back().so_far > kMaxPatterns) {
      return "stands for more than " + std::to_string(kMaxPatterns) +
             " patterns by its braces; give a list of patterns";
    }
  }
  return {};
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
    if (io::is_file(file) || io::is_broken_link(file)) files.push_back(std::move(file));
  }
  // Not glob's own order, which follows the locale; two parts of a {a,b} may match the same file.
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace plastica::calibrate
