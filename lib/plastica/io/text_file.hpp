#pragma once

#include <string>

#include "plastica/io/output_file.hpp"

namespace plastica::io {

/// The whole of a file, byte by byte. @throws StorageError if it cannot be read
std::string read_text_file(const std::string& path);

/// Writes a file whole, or leaves what is there. @throws StorageError as `OutputFile`
void write_text_file(const std::string& path, const std::string& text,
                     Overwrite overwrite = Overwrite::Allowed);

}  // namespace plastica::io
