#include "calibrate/target/tables_of_files.hpp"

#include <cstddef>
#include <map>

#include "plastica/io/content_digest.hpp"

namespace plastica::calibrate {

std::vector<TableOfFile> tables_of(const TargetSource& source) {
  constexpr std::size_t kMostOpen = 100;
  std::vector<TableOfFile> all;
  std::map<std::string, std::size_t> count;  // of keys
  std::size_t open = 0;
  for (const std::string& file : source.files) {
    std::shared_ptr<const io::Hdf5Tables> tables;
    if (io::begins_as_result(file) && !source.csv.sheet) {
      try {
        tables = std::make_shared<const io::Hdf5Tables>(file);
      } catch (const InputError&) {  // its reading says why
      }
    }
    if (!tables) {
      all.push_back({file});
      continue;
    }
    try {
      const std::vector<std::string> paths = tables->matching(source.csv.path);
      const bool stays = paths.size() > 1 && open < kMostOpen;
      if (stays) ++open;
      for (const std::string& path : paths) {
        all.push_back({file, path, stays ? tables : nullptr});
        if (path == "/") continue;
        all.back().within = path;
        all.back().last = path.substr(path.rfind('/') + 1);
        ++count[path];
        if (all.back().last != path) ++count[all.back().last];
      }
    } catch (const InputError& error) {
      all.push_back({file});
      all.back().lacking = std::make_shared<const InputError>(error);
    }
  }
  for (TableOfFile& table : all) {
    table.key = count[table.within] == 1 ? table.within : "";
    if (count[table.last] > 1) table.last.clear();
  }
  return all;
}

}  // namespace plastica::calibrate
