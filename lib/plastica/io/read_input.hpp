#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// What users name as input: files, pipes, and whatever else a path may lead to.
namespace plastica::io {

/// The largest table of measured values that is read [bytes].
inline constexpr std::size_t kMaxTableBytes = std::size_t{1} << 30U;

/// The largest scene, fit, sweep or check file that is read [bytes].
inline constexpr std::size_t kMaxTomlBytes = std::size_t{16} << 20U;

/// The whole of a text that a user gives, byte by byte: of a file, or of a pipe up to its end.
/// UTF-16, with its mark or without, is turned into UTF-8.
///
/// Reads no further than the first zero byte and not beyond the limit, so that a device or a pipe
/// without end is refused in bounded memory.
/// @param max_bytes  the limit, inclusive
/// @throws InputError if it cannot be read, is no text, or larger than the limit
std::string read_input(const std::string& path, std::size_t max_bytes);

/// Refuses what no text has.
/// @throws InputError for a workbook and a MATLAB file, with what to do, and for a zero byte, with
///         its line
void refuse_binary(std::string_view bytes, const std::string& file);

/// Whether a text is UTF-8.
bool is_utf8(std::string_view text);

/// Whether a path leads to a regular file; what cannot be looked at is none.
bool is_file(const std::filesystem::path& path);

/// Whether a path is a link that leads nowhere, or back to itself.
bool is_broken_link(const std::filesystem::path& path);

/// What to say behind "is not a file" of a path that is none: ": Too many levels of symbolic
/// links"; empty where nothing is there.
std::string why_no_file(const std::filesystem::path& path);

}  // namespace plastica::io
