#pragma once

#include <string>

#include "plastica/io/storage_error.hpp"

namespace plastica::io {

/// Forces a file's content, or a folder's entries, to the disk. @throws StorageError
void sync_to_disk(const std::string& path);

/// Moves a finished file to its name and forces the folder's entry to the disk.
/// @throws StorageError
void move_into_place(const std::string& from, const std::string& to);

/// Folder in which a path stands; "." for a bare name.
std::string folder_of(const std::string& path);

}  // namespace plastica::io
