#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "plastica/base/stop_flag.hpp"
#include "plastica/io/hdf5.hpp"
#include "plastica/io/output_file.hpp"
#include "plastica/io/scene_store.hpp"

/// Scenes for ParaView; not installed.
namespace plastica::report {

/// Who may stop the writing of frames, and who is told of it.
struct FrameHooks {
  StopFlag stop = nullptr;  ///< once raised, nothing is written; may be null
  std::function<void(std::size_t done)> on_frame{};  ///< after each frame, how many are done
};

/// Writes the frames of a scene into an open file as VTK's group, version 2.0 of its format:
/// PolyData with time steps, the beam as `BeamMesh` sweeps it. Data of points: `displacement` [m]
/// and, of a motion, `velocity` [m/s]; of cells: `segment`, `joint`, `fragment` and, of their
/// joint, in its axes, `moment` [N m], `force` [N], `plastic_angle` [rad], `plastic_strain` [1],
/// `stress` [Pa].
/// Source: VTK File Formats, "VTKHDF", docs.vtk.org. ParaView reads it from 5.12 on.
/// @param root  of the file, in which `io::kVtkGroup` is made
/// @return false if it was stopped: the file is not to be committed
/// @throws InputError for a coupon, and for a scene without a frame
/// @throws StorageError if it cannot be written
bool write_vtkhdf(io::Hdf5Group& root, const io::SceneRecord& record, const FrameHooks& hooks = {});

/// The same as a file that has nothing else.
bool write_vtkhdf(const std::string& path, const io::SceneRecord& record,
                  io::Overwrite overwrite = io::Overwrite::Allowed, const FrameHooks& hooks = {});

/// The times of the frames as such files have them [s]: readers sort them. Where they do not rise,
/// as along a path that falls, the numbers of the frames stand in their place.
std::vector<double> times_of_steps(const io::SceneRecord& record);
bool has_rising_times(const io::SceneRecord& record);

/// The same frames for readers that do not know VTK's HDF5 file, or not its time steps, as ParaView
/// before 5.12: an XDMF text that refers to the numbers of that file.
/// @param heavy  name of the file that `write_vtkhdf` writes, as seen from the folder of the text
std::string xdmf_text(const io::SceneRecord& record, const std::string& heavy);

}  // namespace plastica::report
