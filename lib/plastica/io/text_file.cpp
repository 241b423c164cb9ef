#include "plastica/io/text_file.hpp"

#include <fstream>
#include <iterator>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

std::string read_text_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.is_open() || in.bad()) throw StorageError(path, "cannot be read");
  return text;
}

void write_text_file(const std::string& path, const std::string& text, Overwrite overwrite) {
  OutputFile file(path, overwrite);
  file.write(text);
  file.commit();
}

}  // namespace plastica::io
