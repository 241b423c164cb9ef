#pragma once

#include <string>

namespace plastica::io {

/// The whole of a file, byte by byte. @throws StorageError if it cannot be read
std::string read_text_file(const std::string& path);

/// Writes a file, over what is there. @throws StorageError if it cannot be written
void write_text_file(const std::string& path, const std::string& text);

}  // namespace plastica::io
