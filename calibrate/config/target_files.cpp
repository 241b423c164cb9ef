#include "calibrate/config/target_files.hpp"

#include <filesystem>
#include <map>

#include "calibrate/config/find_files.hpp"
#include "plastica/io/read_input.hpp"

namespace plastica::calibrate {
namespace {

using io::TomlValue;

/// `files` as single patterns, each with its own place for errors.
std::vector<TomlValue> patterns_of(const TomlValue& files) {
  (void)files.strings();
  return files.is_array() ? files.array() : std::vector<TomlValue>{files};
}

}  // namespace

std::vector<std::string> target_files(const io::TomlTable& table, const std::string& folder) {
  std::vector<std::string> files;
  std::map<std::string, int> lines;
  for (const TomlValue& pattern : patterns_of(table.at("files"))) {
    if (const std::string rule = too_many_braces(pattern.string()); !rule.empty()) {
      throw pattern.error(rule);
    }
    const std::vector<std::string> found = find_files(folder, pattern.string());
    if (found.empty()) {
      const auto path = std::filesystem::path(folder) / pattern.string();
      throw pattern.error("matches no file" + (folder.empty() ? "" : " in " + folder) +
                          io::why_no_file(path));
    }
    for (const std::string& file : found) {
      files.push_back(std::filesystem::path(file).lexically_normal().string());
      const auto [known, is_new] = lines.emplace(files.back(), pattern.where().line);
      if (!is_new) {
        throw pattern.error("matches " + files.back() + ", which line " +
                            std::to_string(known->second) + " has already");
      }
    }
  }
  return files;
}

}  // namespace plastica::calibrate
