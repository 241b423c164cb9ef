#pragma once

#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/scene_store.hpp"

/// Scenes for ParaView; not installed.
namespace plastica::report {

/// The group of such a file, by VTK's specification.
inline constexpr const char* kVtkGroup = "VTKHDF";

/// Writes the frames of a scene as VTK's HDF5 file, version 2.0 of its format: PolyData with time
/// steps, the beam as `BeamMesh` sweeps it. Data of points: `displacement` [m]; of cells:
/// `segment`, `joint`, `fragment` and, of their joint, in its axes, `moment` [N m], `force` [N],
/// `plastic_angle` [rad], `plastic_strain` [1], `stress` [Pa].
/// Source: VTK File Formats, "VTKHDF", docs.vtk.org. ParaView reads it from 5.12 on.
/// @param stop  once raised, nothing is written; may be null
/// @return false if it was stopped
/// @throws InputError for a coupon, and for a scene without a frame
/// @throws StorageError if it cannot be written
bool write_vtkhdf(const std::string& path, const io::SceneRecord& record,
                  io::Overwrite overwrite = io::Overwrite::Allowed, StopFlag stop = nullptr);

/// The times of the frames as such files have them [s]: readers sort them. Where they do not rise,
/// as along a path that falls, the numbers of the frames stand in their place.
std::vector<double> times_of_steps(const io::SceneRecord& record);
bool has_rising_times(const io::SceneRecord& record);

/// The same frames for readers that do not know VTK's HDF5 file, or not its time steps, as ParaView
/// before 5.12: an XDMF text that refers to the numbers of that file.
/// @param heavy  name of the file that `write_vtkhdf` writes, as seen from the folder of the text
std::string xdmf_text(const io::SceneRecord& record, const std::string& heavy);

}  // namespace plastica::report
