#pragma once

#include <string>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

/// Forces a file's content, or a folder's entries, to the disk. @throws StorageError
void sync_to_disk(const std::string& path);

/// Folder in which a path stands; "." for a bare name.
std::string folder_of(const std::string& path);

}  // namespace plastica::io
