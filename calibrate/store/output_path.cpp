#include <unistd.h>

#include <filesystem>

#include "calibrate/store/fit_store.hpp"
#include "plastica/io/durable_file.hpp"

namespace plastica::calibrate {

void check_output_path(const std::string& path, bool force) {
  namespace fs = std::filesystem;
  const auto refuse = [&](const std::string& rule) { throw InputError({path, 0}, "", "", rule); };
  if (path.empty()) throw InputError({}, "output", "", "must name a file");
  std::error_code ignored;
  const std::string folder = io::folder_of(path);
  if (!fs::exists(folder, ignored)) refuse("cannot be written: there is no folder " + folder);
  if (!fs::is_directory(folder, ignored)) refuse("cannot be written: " + folder + " is no folder");
  if (fs::is_directory(path, ignored)) refuse("cannot be written: it is a folder");
  if (fs::exists(path, ignored) && !force) refuse("exists already: use --force to overwrite it");
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse("cannot be written: the folder " + folder + " is closed to writing");
  }
}

}  // namespace plastica::calibrate
