#include "tests/fuzz/fuzz_target.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace plastica::fuzz {
namespace {

/// Gone when the process ends; a crash leaves it.
class ScratchFolder {
 public:
  ScratchFolder() {
    path_ = (std::filesystem::temp_directory_path() / "plastica-fuzz-XXXXXX").string();
    if (::mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot create " + path_);
    std::filesystem::copy(PLASTICA_SOURCE_DIR "/tests/fuzz/inputs", path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

std::vector<Target>& targets() {
  static std::vector<Target> all;
  return all;
}

void check_refusal(std::string_view what) {
  require(!what.empty(), "an error without words");
  for (const char c : what) {
    const auto code = static_cast<unsigned char>(c);
    // Tabs of a table's line are shown as they are.
    if ((code < ' ' && c != '\t') || c == '\x7F') {
      throw Broken("an error that is not one line: " + std::string(what));
    }
  }
}

std::string scratch_path(const std::string& name) {
  static const ScratchFolder folder;
  return folder.path() + "/" + name;
}

std::string scratch_file(const std::string& name, std::string_view content) {
  std::string path = scratch_path(name);
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
  return path;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace plastica::fuzz
