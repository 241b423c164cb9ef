#pragma once

#include <string>

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
/// @throws InputError for a coupon, and for a scene without a frame
/// @throws StorageError if it cannot be written
void write_vtkhdf(const std::string& path, const io::SceneRecord& record,
                  io::Overwrite overwrite = io::Overwrite::Allowed);

/// The same frames for readers that do not know VTK's HDF5 file, or not its time steps, as ParaView
/// before 5.12: an XDMF text that refers to the numbers of that file.
/// @param heavy  name of the file that `write_vtkhdf` writes, as seen from the folder of the text
std::string xdmf_text(const io::SceneRecord& record, const std::string& heavy);

}  // namespace plastica::report
