#pragma once

#include <cstddef>
#include <string>

namespace plastica::io {

/// A result file is an HDF5 file behind a block of 512 bytes (HDF5 calls it a user block), which
/// says in three lines of text what stands behind it: how many bytes, and their digest (XXH3, 64
/// bits). It is written last and checked before HDF5 reads anything, since HDF5 takes most flipped
/// bits for what was meant, and crashes on others.
inline constexpr std::size_t kContentOffset = 512;

/// Writes the block in front of a file's content, which is complete.
/// @param descriptor  open for reading and writing
/// @param path        for messages
/// @throws StorageError
void write_content_digest(int descriptor, const std::string& path);

/// Checks that a file is the one that was written.
/// @return whether it has a digest; false for a file that an older version, or another program,
///         has written: an HDF5 file without a block in front
/// @throws InputError if it cannot be read, is no HDF5 file, is cut off, or differs from its digest
bool check_content_digest(const std::string& path);

/// Whether a file begins with the block. Never throws.
bool begins_with_digest(const std::string& path);

/// Whether a file begins as a result does, with the block or as HDF5. Says nothing of the rest, and
/// false of what cannot be read or is no regular file: a pipe is not read.
bool begins_as_result(const std::string& path);

}  // namespace plastica::io
