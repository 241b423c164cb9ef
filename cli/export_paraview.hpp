#pragma once

#include <array>
#include <string>
#include <string_view>

namespace plastica::io {
struct SceneRecord;
}

namespace plastica::cli {

/// Says so where the steps of a file for ParaView have numbers in the place of times.
void tell_of_numbered_steps(const io::SceneRecord& record);

/// Formats that ParaView reads, which go to files alone.
inline constexpr std::array<std::string_view, 2> kParaviewFormats{"vtkhdf", "xdmf"};

bool is_for_paraview(std::string_view format);

/// Writes the frames of a scene for ParaView; as xdmf with the numbers in a file beside it, whose
/// name ends in .vtkhdf in the place of .xdmf, or behind another ending.
/// @param file    result of a scene
/// @param format  one of `kParaviewFormats`
/// @return the exit code
/// @throws InputError for what is no scene or has no beam, and for an output that cannot be
int write_for_paraview(const std::string& file, std::string_view format, const std::string& output,
                       bool force);

}  // namespace plastica::cli
